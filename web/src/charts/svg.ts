// A chart as SVG, for papers: axes with ticks, the curves, their names.
import { svg } from "../dom";
import { text } from "../numbers";
import { colour, dash } from "./colours";
import { least, most, ticks } from "./scale";
import type { Plot } from "./plot";

const width = 720, height = 460, left = 70, right = 20, top = 20, bottom = 54;

export function svgOf(p: Plot): string {
  const map = (log: boolean | undefined) => (v: number): number => (log ? Math.log10(v) : v);
  const fx = map(p.xLogarithmic), fy = map(p.logarithmic);
  const xs = p.x.map(fx), ys = p.curves.flatMap((c) => c.values.filter((v): v is number => v !== null && Number.isFinite(fy(v))).map(fy));
  const x0 = least(xs), x1 = most(xs), y0 = least(ys), y1 = most(ys);
  const px = (v: number): number => left + ((v - x0) / (x1 - x0 || 1)) * (width - left - right);
  const py = (v: number): number => height - bottom - ((v - y0) / (y1 - y0 || 1)) * (height - top - bottom);
  const label = (v: number, log: boolean | undefined): string => (log ? text(10 ** v, 3) : text(v, 5));
  const root = svg("svg", { xmlns: "http://www.w3.org/2000/svg", viewBox: `0 0 ${width} ${height}`, width, height, "font-family": "sans-serif", "font-size": 12 },
    svg("title", {}, p.title), svg("rect", { width, height, fill: "white" }),
    ticks(x0, x1, 6).map((v) => svg("g", {}, svg("line", { x1: px(v), x2: px(v), y1: top, y2: height - bottom, stroke: "#ddd" }), svg("text", { x: px(v), y: height - bottom + 16, "text-anchor": "middle" }, label(v, p.xLogarithmic)))),
    ticks(y0, y1, 6).map((v) => svg("g", {}, svg("line", { x1: left, x2: width - right, y1: py(v), y2: py(v), stroke: "#ddd" }), svg("text", { x: left - 6, y: py(v) + 4, "text-anchor": "end" }, label(v, p.logarithmic)))),
    svg("text", { x: (left + width - right) / 2, y: height - 12, "text-anchor": "middle" }, p.xName),
    svg("text", { transform: `translate(16 ${(top + height - bottom) / 2}) rotate(-90)`, "text-anchor": "middle" }, p.yName),
    p.curves.map((c, k) => {
      let d = "", pen = "M";
      c.values.forEach((v, i) => {
        if (v === null || !Number.isFinite(fy(v))) { pen = "M"; return; }
        d += `${pen}${px(xs[i] ?? 0).toFixed(2)} ${py(fy(v)).toFixed(2)}`;
        pen = "L";
      });
      return svg("path", { d, fill: "none", stroke: c.guide ? "#999" : c.colour ?? colour(k), "stroke-width": c.guide ? 1 : 1.8, "stroke-dasharray": (c.dash ?? (c.guide ? [3, 4] : dash(k))).join(" ") || null }, svg("title", {}, c.name));
    }));
  return new XMLSerializer().serializeToString(root);
}
