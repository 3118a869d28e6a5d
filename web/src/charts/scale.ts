// Ends and ticks of an axis.

/** The largest of any number of values, −∞ of none: a call has room for some 10⁵ arguments only. */
export const most = (values: Iterable<number>): number => { let m = -Infinity; for (const v of values) m = v > m ? v : m; return m; };
export const least = (values: Iterable<number>): number => { let m = Infinity; for (const v of values) m = v < m ? v : m; return m; };

/** Round numbers from one end to the other, about so many steps. */
export function ticks(low: number, high: number, steps: number): number[] {
  const raw = (high - low) / steps, power = 10 ** Math.floor(Math.log10(raw || 1));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw) ?? 1;
  const all: number[] = [];
  for (let v = Math.ceil(low / step) * step; v <= high + 1e-9 * step; v += step) all.push(Number(v.toPrecision(12)));
  return all;
}
