// Numbers as people read them. Each stands in a <data> element whose value is the number of the document.
import { el, type Child } from "./dom";
import type { Unit } from "./documents";

const perRadian: Record<Unit, number> = { "rad/s": 1, Hz: 1 / (2 * Math.PI), rpm: 60 / (2 * Math.PI) };

export const inUnit = (omega: number, unit: Unit): number => omega * perRadian[unit];

/** Shortest text with so many significant digits. */
export function text(x: number, digits = 6): string {
  if (x === 0) return "0";
  if (!Number.isFinite(x)) return x > 0 ? "∞" : "−∞";
  const size = Math.abs(x);
  if (size >= 1e-4 && size < 1e7) return String(Number(x.toPrecision(digits)));
  return x.toExponential(Math.max(0, digits - 1)).replace(/\.?0+e/, "e").replace("e+", "e");
}

/** As many digits as an error leaves, 4 to 10. */
export function digitsOf(x: number, error: number | null | undefined, most = 8): number {
  if (!error || !x) return most;
  return Math.min(most, Math.max(4, Math.floor(-Math.log10(error / Math.abs(x)))));
}

export function number(x: number | null | undefined, digits = 6): Child {
  if (x === null || x === undefined) return "–";
  return el("data", { value: x, title: String(x) }, text(x, digits));
}

export function frequency(omega: number | null | undefined, unit: Unit, digits = 8): Child {
  if (omega === null || omega === undefined) return "–";
  return el("data", { value: omega, title: `${omega} rad/s`, "data-unit": unit }, text(inUnit(omega, unit), digits));
}

export function percent(x: number): Child {
  return el("data", { value: x, title: String(x), "data-unit": "%" }, `${text(100 * x, 3)} %`);
}
