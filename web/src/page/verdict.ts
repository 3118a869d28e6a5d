// The verdict with the balance that it rests on.
import { el } from "../dom";
import type { Balance, Stability, Unit, Unstable } from "../documents";
import { digitsOf, frequency, number } from "../numbers";
import { explained, verdicts } from "../words";
import { table } from "./table";

export function verdict(stability: Stability, b: Balance): HTMLElement {
  const term = (factor: string, value: number, name: string) => el("span", { class: "term" }, factor, number(value), el("small", {}, name));
  return el("section", { class: "verdict" }, el("h3", {}, "Stability"),
    el("p", {}, el("strong", { class: `badge ${stability}` }, verdicts[stability]), " ", explained[stability]),
    el("p", { class: "balance", "aria-label": "index balance" }, term("", b.negative, "n₋(K)"), b.closed ? " = " : " ≠ ",
      term("", b.real_pairs, "divergent"), " + ", term("2·", b.quadruples, "flutter"), " + ", term("2·", b.negative_energy, "of negative energy"),
      b.zero_negative ? [" + ", term("", b.zero_negative, "of zero roots")] : null,
      el("span", { class: b.closed ? "good" : "doubtful" }, b.closed ? " closed" : " open")));
}

export function unstable(all: readonly Unstable[], unit: Unit): HTMLElement | null {
  if (all.length === 0) return null;
  return table("Growing motions", [
    { heading: "kind", key: "kind", cell: (u) => u.kind, value: (u) => u.kind },
    { heading: "growth rate [1/s]", key: "growth_rate", cell: (u) => number(u.growth_rate, digitsOf(u.growth_rate, u.error_bound)), value: (u) => u.growth_rate },
    { heading: `ω [${unit}]`, key: "omega", cell: (u) => frequency(u.omega, unit), value: (u) => u.omega },
  ], all);
}
