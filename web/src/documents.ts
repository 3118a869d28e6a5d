// The documents of gyromode as far as the page reads them (docs/results.md has all of it). Frequencies are in rad/s.

export type Unit = "rad/s" | "Hz" | "rpm";
export type Stability = "stable" | "gyroscopically_stabilised" | "marginal" | "unstable" | "unknown";

export interface Complexes { re: number[]; im: number[] }
export interface Shape extends Complexes { labels?: string[] }
export interface Points { re: number[][]; im: number[][] }

export interface Coverage {
  status: "complete" | "incomplete" | "not_counted";
  window: [number, number | null];
  requested?: [number, number | null];
  found: number;
  counted: number | null;
  reason?: string;
  interrupted?: boolean;
}

export interface Balance {
  negative: number; real_pairs: number; quadruples: number; negative_energy: number;
  zero: number; zero_negative?: number; closed: boolean;
}

export interface StructureFacts {
  class: "quadrature" | "hidden_quadrature" | "general" | "transcendental";
  in_phase?: string[]; quadrature?: string[];
  stiffness?: string; negative?: number; zero?: number; path?: string;
}

export interface Orbit { whirl: string | null; major: number; minor: number; inclination: number }

export interface Mode {
  omega: number; frequency_hz?: number; kind: string; energy_sign: number; multiplicity?: number;
  residual?: number; error_bound?: number; whirl?: string | null; name?: string | null;
  orbits?: Record<string, Orbit>;
  participation?: { kinetic?: Record<string, number>; strain?: Record<string, number> };
  fixed_axes?: { omega: number; share: number }[];
  shape?: Shape; displacements?: Points;
}

export interface Unstable {
  growth_rate: number; omega: number; kind: string; residual?: number; error_bound?: number;
  shape?: Shape; displacements?: Points;
}

/** `displacements`: of version 2, of every mode in order; in version 1 each mode has its own. */
export interface Geometry { points: number[][]; lines: { name: string; points: number[] }[]; displacements?: unknown }

export interface Sensitivity {
  key: string; value: number; unit?: string;
  slope: (number | null)[]; relative: (number | null)[]; error?: (number | null)[];
}

interface Common {
  schema: string;
  model: { title: string; sha256?: string; coordinates?: number; kind?: string; frame?: string | null };
  versions?: Record<string, string>;
  units?: Unit;
  parameters?: Record<string, number>;
  options?: Record<string, unknown>;
  timings?: { at?: string; read_s?: number; solve_s?: number };
}

export interface ModesDocument extends Common {
  structure: StructureFacts; stability: Stability; index_balance: Balance; coverage: Coverage;
  modes: Mode[]; unstable: Unstable[]; geometry?: Geometry | null; sensitivity?: Sensitivity[];
  negative_modes?: Mode[]; repairs?: unknown[];
  /** Of version 2: all shapes as one block. */
  shapes?: { labels: string[]; re: number[][]; im: number[][] };
}

export interface Branch {
  omega: (number | null)[]; whirl: (string | null)[]; energy_sign: (number | null)[];
  slope?: (number | null)[]; error_bound?: (number | null)[]; coverage?: (string | null)[]; multiplicity?: number;
}

export interface CampbellDocument extends Common {
  spins: number[]; coverage: string[]; stability: Stability[]; growth_rate?: number[]; branches: Branch[];
  events: { kind: string; spin: number; branches: number[]; gap?: number; interval?: [number, number] }[];
  excitation: { order: number; spin: number; omega: number; branch: number; whirl?: string | null; error_bound?: number }[];
}

export interface CriticalSpeed { omega: number; rpm: number; whirl?: string | null; multiple?: number; residual?: number; error_bound?: number; shape?: Shape }
export interface CriticalDocument extends Common {
  order: number; coverage?: Coverage; critical_speeds?: CriticalSpeed[]; not_physical?: number;
  over?: string; map?: { value: number; status: string; critical_speeds: CriticalSpeed[] }[]; sensitivity?: Sensitivity[];
}

export interface StabilityDocument extends Common {
  stability: Stability; index_balance: Balance; unstable: Unstable[]; negative_modes?: Mode[];
  margin?: Record<string, unknown>; damping?: { growing_roots: number; destabilised: number[] };
  varied?: string[]; map?: { values: number[]; stability: Stability | null; growth_rate: number | null }[];
  critical?: { key: string; value: number; bracket?: [number, number]; from: string; to: string }[];
}

export interface StructureDocument extends Common {
  structure: StructureFacts; components: string[][]; witness?: string[]; checks?: Record<string, unknown>;
  at?: { omega: number; H: { re: number[][]; im: number[][] }; H_star: number[][]; by?: string };
}

export interface CountDocument extends Common {
  window: [number, number | null]; requested: [number, number | null]; count: number | null; signed: number;
  zero: number; negative: number[]; status: string;
}

export type AnyDocument = Common & Record<string, unknown>;
export interface Named { name: string; document: AnyDocument }

/** A document of modes with a shape and displacements with each mode, whatever its version. */
export function withShapes(d: ModesDocument): ModesDocument {
  const moved = d.geometry?.displacements;
  if (!d.shapes && !Array.isArray(moved)) return d;
  const modes = d.modes.map((m, k): Mode => {
    const re = d.shapes?.re[k], im = d.shapes?.im[k], displacements = Array.isArray(moved) ? (moved[k] as Points | null) : null;
    return { ...m, ...(d.shapes && re && im ? { shape: { labels: d.shapes.labels, re, im } } : {}), ...(displacements ? { displacements } : {}) };
  });
  return { ...d, modes };
}

/** "modes" of "gyromode/modes/1". */
export const kindOf = (d: AnyDocument): string => d.schema.split("/")[1] ?? "";
