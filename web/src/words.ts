// What the words of documents mean to people.
import type { Stability } from "./documents";

export const verdicts: Record<Stability, string> = {
  stable: "stable",
  gyroscopically_stabilised: "stabilised by gyroscopic forces",
  marginal: "marginal",
  unstable: "unstable",
  unknown: "not known",
};

export const explained: Record<Stability, string> = {
  stable: "Every motion stays small, whatever little damping there is.",
  gyroscopically_stabilised: "Motions stay small without damping; damping of the body makes those of negative energy grow.",
  marginal: "A root is zero within rounding: motions may drift.",
  unstable: "At least one motion grows; it was shown to exist.",
  unknown: "The balance does not close: nothing is claimed.",
};

export const classes: Record<string, string> = {
  quadrature: "Coordinates move partly in phase, partly in quadrature: H(ω) is real symmetric of order n after one change of phase.",
  hidden_quadrature: "A symmetry that reverses the spin makes H(ω) real symmetric in other coordinates.",
  general: "No partition into coordinates in phase and in quadrature exists: H(ω) stays complex.",
  transcendental: "Booms are exact: H(ω) has infinitely many roots.",
};

export const coverages: Record<string, string> = {
  complete: "every mode of the window was found, and counted",
  incomplete: "modes may be missing",
  not_counted: "not counted",
};

export const signs = (s: number | null | undefined): string => (s === 1 ? "+" : s === -1 ? "−" : "0");
export const spoken = (word: string): string => word.replaceAll("_", " ");
