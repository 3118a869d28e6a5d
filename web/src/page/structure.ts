// In phase, in quadrature, or neither: the partition, the pattern of H before and after it, and the odd cycle.
import { el, svg } from "../dom";
import type { StructureDocument, StructureFacts } from "../documents";
import { frequency, number } from "../numbers";
import { classes, spoken } from "../words";
import { facts } from "./table";

const most = 40;  // coordinates that are drawn

function group(name: string, labels: readonly string[], mark: string): HTMLElement {
  const shown = labels.slice(0, most);
  return el("div", { class: `group ${mark}` }, el("h4", {}, `${name} (${labels.length})`),
    el("ul", { class: "labels" }, shown.map((l) => el("li", {}, l)), labels.length > shown.length ? el("li", { class: "more" }, `… ${labels.length - shown.length} more`) : null));
}

/** Which entries are real (in phase), imaginary (cross), or zero. */
function pattern(title: string, rows: number[][], imaginary: number[][] | null, order: readonly number[]): HTMLElement {
  const n = order.length, cell = Math.min(18, 320 / n);
  const largest = Math.max(...rows.flat().map(Math.abs), ...(imaginary?.flat().map(Math.abs) ?? [0]), 1e-300);
  const squares = order.flatMap((i, r) => order.map((j, c) => {
    const re = Math.abs(rows[i]?.[j] ?? 0), im = Math.abs(imaginary?.[i]?.[j] ?? 0);
    const kind = im > re ? "imaginary" : re > 0 ? "real" : "";
    if (!kind) return null;
    const strength = 0.25 + 0.75 * Math.max(0, 1 + Math.log10(Math.max(re, im) / largest) / 8);
    return svg("rect", { x: c * cell, y: r * cell, width: cell - 1, height: cell - 1, class: kind, "fill-opacity": Math.min(1, strength).toFixed(2) });
  }));
  return el("figure", { class: "pattern" },
    svg("svg", { viewBox: `0 0 ${n * cell} ${n * cell}`, width: n * cell, role: "img", "aria-label": `${title}: pattern of a ${n} by ${n} matrix` },
      svg("rect", { x: 0, y: 0, width: n * cell, height: n * cell, class: "frame" }), squares), el("figcaption", {}, title));
}

// Of two coordinates: coupled through M or K and through G at once, which is a cycle of two.
function oddCycle(labels: readonly string[]): HTMLElement {
  const n = labels.length, radius = 90, centre = 130;
  const at = (k: number): [number, number] => [centre + radius * Math.sin((2 * Math.PI * k) / n), centre - radius * Math.cos((2 * Math.PI * k) / n)];
  const [top, bottom] = [at(0), at(1)];
  const edges = n === 2
    ? [-60, 60].map((bow, k) => svg("path", { d: `M${top[0]} ${top[1]}Q${centre + bow} ${centre} ${bottom[0]} ${bottom[1]}`, class: k === 0 ? "edge in-phase" : "edge" }))
    : labels.map((_, k) => { const [x1, y1] = at(k), [x2, y2] = at((k + 1) % n); return svg("line", { x1, y1, x2, y2, class: "edge" }); });
  const words = n === 2 ? `${labels.join(" and ")} are coupled through M or K (blue) and through G (orange) at once: no partition exists.`
    : "An odd cycle: going round, the number of couplings through G is odd, so that no partition exists.";
  return el("section", {}, el("h3", {}, "Why there is no partition"), el("figure", { class: "cycle" },
    svg("svg", { viewBox: "0 0 260 260", width: 260, role: "img", "aria-label": `odd cycle through ${labels.join(", ")}` }, edges,
      labels.map((l, k) => { const [x, y] = at(k); return svg("g", {}, svg("circle", { cx: x, cy: y, r: 5 }), svg("text", { x, y: y > centre ? y + 18 : y - 10, "text-anchor": "middle" }, l.slice(0, 14))); })),
    el("figcaption", {}, words)));
}

export function structure(s: StructureFacts): HTMLElement {
  const inPhase = s.in_phase ?? [], across = s.quadrature ?? [];
  return el("section", { class: "structure" }, el("h3", {}, "Structure"),
    el("p", {}, el("strong", {}, spoken(s.class)), ". ", classes[s.class] ?? ""),
    across.length + inPhase.length > 0 ? el("div", { class: "partition" }, group("in phase", inPhase, "real"), group("in quadrature", across, "imaginary")) : null,
    facts([["K", el("span", {}, s.stiffness ?? "–", s.negative === undefined ? null : el("span", {}, ", ", number(s.negative), " negative"), s.zero ? el("span", {}, ", ", number(s.zero), " zero") : null)],
      ...(s.path ? [["solver", s.path] as [string, string]] : [])]));
}

export function structurePage(d: StructureDocument): HTMLElement[] {
  const labels = [...(d.structure.in_phase ?? []), ...(d.structure.quadrature ?? [])];
  const all = d.components.flat();
  const grouped = labels.map((l) => all.indexOf(l)).filter((i) => i >= 0);
  const parts: HTMLElement[] = [structure(d.structure)];
  if (d.witness && d.witness.length > 0) parts.push(oddCycle(d.witness));
  if (d.at && d.at.H.re.length <= most) {
    const n = d.at.H.re.length, given = [...Array(n).keys()], order = grouped.length === n ? grouped : given;
    parts.push(el("section", {}, el("h3", {}, "H(ω) before and after"),
      el("p", {}, "At ω = ", frequency(d.at.omega, "rad/s"), " rad/s. Blue: real entries; orange: imaginary ones. ", d.at.by === "partition" ? "T = diag(1, −j) makes all real." : "U, which the document holds, makes all real at this frequency."),
      el("div", { class: "patterns" }, pattern("H, as given", d.at.H.re, d.at.H.im, given), pattern("H, grouped", d.at.H.re, d.at.H.im, order), pattern(d.at.by === "partition" ? "H* = TᴴHT" : "H* = UᴴHU", d.at.H_star, null, order))));
  }
  return parts;
}
