// The verdict, and its map over numbers of the model.
import { el, svg } from "../dom";
import type { StabilityDocument, Unit } from "../documents";
import { number, text } from "../numbers";
import { spoken, verdicts } from "../words";
import { Chart } from "../charts/plot";
import { table } from "./table";
import { unstable, verdict } from "./verdict";

function strip(d: StabilityDocument): HTMLElement {
  const map = d.map ?? [], x = map.map((m) => m.values[0] ?? 0), low = x[0] ?? 0, high = x[x.length - 1] ?? 1, width = 720;
  const at = (v: number): number => ((v - low) / (high - low || 1)) * width;
  const borders = (d.critical ?? []).map((c) => c.value).sort((a, b) => a - b);
  const ends = [low, ...borders, high];
  const bands = ends.slice(0, -1).map((a, k) => {
    const b = ends[k + 1] ?? high, inside = map.find((m) => (m.values[0] ?? 0) > a && (m.values[0] ?? 0) < b) ?? map.find((m) => (m.values[0] ?? 0) >= a);
    return svg("rect", { x: at(a), y: 0, width: Math.max(0, at(b) - at(a)), height: 36, class: `verdict-band ${inside?.stability ?? "unknown"}` }, svg("title", {}, inside?.stability ? verdicts[inside.stability] : "no model"));
  });
  return el("figure", {}, svg("svg", { viewBox: `0 0 ${width} 60`, class: "strip", role: "img", "aria-label": `Verdicts over ${d.varied?.[0] ?? ""}` }, bands,
    borders.map((c) => svg("g", {}, svg("line", { x1: at(c), x2: at(c), y1: 0, y2: 40, class: "border" }), svg("text", { x: at(c), y: 54, "text-anchor": "middle" }, text(c, 5))))),
    el("figcaption", { class: "legend" }, [...new Set(map.map((m) => m.stability ?? "unknown"))].map((s) => el("span", { class: `key ${s}` }, verdicts[s])), ` over ${d.varied?.[0] ?? ""}`));
}

function plane(d: StabilityDocument): HTMLElement {
  const map = d.map ?? [], side = 480;
  const xs = [...new Set(map.map((m) => m.values[0] ?? 0))], ys = [...new Set(map.map((m) => m.values[1] ?? 0))];
  const w = side / xs.length, h = side / ys.length;
  const cells = map.map((m) => svg("rect", { x: xs.indexOf(m.values[0] ?? 0) * w, y: side - (ys.indexOf(m.values[1] ?? 0) + 1) * h, width: w + 0.5, height: h + 0.5, class: `verdict-band ${m.stability ?? "unknown"}` },
    svg("title", {}, `${m.values.map((v) => text(v, 5)).join(", ")}: ${m.stability ? verdicts[m.stability] : "no model"}`)));
  return el("figure", {}, svg("svg", { viewBox: `0 0 ${side} ${side}`, class: "plane", role: "img", "aria-label": `Verdicts over ${(d.varied ?? []).join(" and ")}` }, cells),
    el("figcaption", {}, `across: ${d.varied?.[0] ?? ""}, ${text(xs[0] ?? 0, 4)} to ${text(xs[xs.length - 1] ?? 0, 4)}; up: ${d.varied?.[1] ?? ""}, ${text(ys[0] ?? 0, 4)} to ${text(ys[ys.length - 1] ?? 0, 4)}. `,
      [...new Set(map.map((m) => m.stability ?? "unknown"))].map((s) => el("span", { class: `key ${s}` }, verdicts[s]))));
}

export function stabilityPage(d: StabilityDocument, unit: Unit): HTMLElement[] {
  const parts: HTMLElement[] = [verdict(d.stability, d.index_balance)];
  const growing = unstable(d.unstable, unit);
  if (growing) parts.push(growing);
  if (d.map && d.map.length > 0) {
    const section = el("section", {}, el("h3", {}, "Stability map"));
    if ((d.varied ?? []).length === 2) section.append(plane(d));
    else {
      section.append(strip(d));
      if (d.map.some((m) => (m.growth_rate ?? 0) > 0)) section.append(new Chart({ title: "Growth rate", x: d.map.map((m) => m.values[0] ?? 0), xName: d.varied?.[0] ?? "", yName: "growth rate [1/s]", height: 260, curves: [{ name: "growth rate", values: d.map.map((m) => m.growth_rate) }] }).element);
    }
    parts.push(section);
  }
  if (d.critical && d.critical.length > 0) parts.push(table("Critical values", [
    { heading: "of", key: "key", cell: (c) => c.key, value: (c) => c.key },
    { heading: "value", key: "value", cell: (c) => number(c.value, 10), value: (c) => c.value },
    { heading: "from", key: "from", cell: (c) => spoken(c.from), value: (c) => c.from },
    { heading: "to", key: "to", cell: (c) => spoken(c.to), value: (c) => c.to },
  ], d.critical));
  return parts;
}
