// A model as points that move: every point at rest, and where a mode moves it, Re(X e^{jφ}).
import type { Geometry, Points } from "../documents";

export type Vector = [number, number, number];

/** p + a (Re X cos φ − Im X sin φ) of all points, one after the other in `out`. */
export function displaced(rest: readonly number[][], x: Points, amplitude: number, phase: number, out: Float32Array): void {
  const c = amplitude * Math.cos(phase), s = amplitude * Math.sin(phase);
  for (let k = 0; k < rest.length; ++k) {
    for (let i = 0; i < 3; ++i) out[3 * k + i] = (rest[k]?.[i] ?? 0) + c * (x.re[k]?.[i] ?? 0) - s * (x.im[k]?.[i] ?? 0);
  }
}

/** The middle of all points at rest, and the largest distance from it. */
export function extent(g: Geometry): { centre: Vector; size: number } {
  const low: Vector = [Infinity, Infinity, Infinity], high: Vector = [-Infinity, -Infinity, -Infinity];
  for (const p of g.points) {
    for (let i = 0; i < 3; ++i) {
      low[i] = Math.min(low[i] ?? 0, p[i] ?? 0);
      high[i] = Math.max(high[i] ?? 0, p[i] ?? 0);
    }
  }
  const centre: Vector = [0, 0, 0];
  let square = 0;
  for (let i = 0; i < 3; ++i) {
    centre[i] = 0.5 * ((low[i] ?? 0) + (high[i] ?? 0));
    square += ((high[i] ?? 0) - (low[i] ?? 0)) ** 2;
  }
  return { centre, size: 0.5 * Math.sqrt(square) || 1 };
}

export const largestDisplacement = (x: Points): number => {
  let most = 0;
  for (let k = 0; k < x.re.length; ++k) most = Math.max(most, Math.hypot(...(x.re[k] ?? []), ...(x.im[k] ?? [])));
  return most || 1;
};
