// Horizontal bars, also to the left of zero: shares of energy, sensitivities, entries of a shape.
import { el, svg, type Child } from "../dom";

export interface Bars { name: string; values: readonly number[] }

export function bars(title: string, names: readonly string[], series: readonly Bars[], worded: (x: number) => Child): HTMLElement {
  const width = 100, thick = series.length > 1 ? 7 : 10, height = series.length * thick + 4;
  const largest = Math.max(...series.flatMap((s) => s.values.map(Math.abs)), 1e-300);
  const signed = series.some((s) => s.values.some((v) => v < 0));
  const zero = signed ? width / 2 : 0, scale = (signed ? width / 2 : width) / largest;
  const row = (i: number): SVGElement => svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "bars", height, preserveAspectRatio: "none", "aria-hidden": "true" },
    svg("line", { x1: zero, x2: zero, y1: 0, y2: height, class: "zero" }), series.map((s, k) => {
      const v = s.values[i] ?? 0, w = Math.abs(v) * scale;
      return svg("rect", { x: v < 0 ? zero - w : zero, y: 2 + k * thick, width: w, height: thick - 1, class: `series-${k}` });
    }));
  return el("figure", { class: "barchart" },
    el("figcaption", {}, title, series.length > 1 ? series.map((s, k) => el("span", { class: `key series-${k}` }, s.name)) : null),
    el("table", { "aria-label": title }, el("tbody", {}, names.map((n, i) => el("tr", {}, el("th", { scope: "row", title: n }, n), el("td", { class: "drawing" }, row(i)),
      series.map((s) => el("td", { class: "number" }, worded(s.values[i] ?? 0))))))));
}
