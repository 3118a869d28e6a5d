// The entries of a shape: how far each coordinate moves, in phase and in quadrature.
import { el } from "../dom";
import type { Shape } from "../documents";
import { number } from "../numbers";
import { bars } from "../charts/bars";

const most = 24;

export function entries(s: Shape): HTMLElement | null {
  const labels = s.labels ?? s.re.map((_, k) => `q${k + 1}`);
  const order = [...labels.keys()].sort((a, b) => Math.hypot(s.re[b] ?? 0, s.im[b] ?? 0) - Math.hypot(s.re[a] ?? 0, s.im[a] ?? 0)).slice(0, most).sort((a, b) => a - b);
  if (order.length === 0) return null;
  const figure = bars("Shape X: motion is Re(X exp jωt)", order.map((k) => labels[k] ?? ""), [
    { name: "real part", values: order.map((k) => s.re[k] ?? 0) }, { name: "imaginary part", values: order.map((k) => s.im[k] ?? 0) }], (x) => number(x, 4));
  return labels.length > order.length ? el("div", {}, figure, el("p", { class: "remark" }, `The ${order.length} largest of ${labels.length} entries.`)) : figure;
}
