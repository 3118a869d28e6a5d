// What was counted where: modes on the frequency axis, their number rising beneath, and the counts at the ends.
import { el, svg } from "../dom";
import type { Coverage, Mode, Unit } from "../documents";
import { frequency, inUnit, number, text } from "../numbers";
import { coverages } from "../words";
import { most, ticks } from "../charts/scale";

const width = 720, height = 190, left = 40, right = 70, top = 16, bottom = 40;

export function countsPicture(coverage: Coverage, modes: readonly Mode[], unit: Unit): SVGElement {
  const listed = modes.map((m) => m.omega);
  const a = coverage.window[0], b = coverage.window[1] ?? Math.max(1e-300, 1.05 * most(listed));
  const total = Math.max(coverage.counted ?? 0, coverage.found, 1);
  const x = (w: number): number => left + ((w - a) / (b - a || 1)) * (width - left - right);
  const y = (n: number): number => height - bottom - (n / total) * (height - bottom - top);
  let seen = 0, path = `M${x(a)} ${y(0)}`;
  for (const m of modes) {
    path += `H${x(m.omega).toFixed(2)}`;
    seen += m.multiplicity ?? 1;
    path += `V${y(seen).toFixed(2)}`;
  }
  path += `H${x(b)}`;
  const good = coverage.status === "complete";
  const marks = modes.map((m) => svg("line", {
    x1: x(m.omega), x2: x(m.omega), y1: height - bottom, y2: height - bottom + (m.energy_sign < 0 ? 14 : 8),
    class: m.energy_sign < 0 ? "mode negative" : m.energy_sign > 0 ? "mode" : "mode zero",
  }));
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "counts", role: "img",
    "aria-label": `${coverage.found} modes found in the window, ${coverage.counted ?? "not"} counted` },
    svg("line", { x1: left, x2: width - right, y1: height - bottom, y2: height - bottom, class: "axis" }),
    ticks(inUnit(a, unit), inUnit(b, unit), 8).map((v) => {
      const at = x(v / inUnit(1, unit));
      return svg("g", { class: "tick" }, svg("line", { x1: at, x2: at, y1: height - bottom, y2: height - bottom + 4 }),
        svg("text", { x: at, y: height - 10, "text-anchor": "middle" }, text(v, 5)));
    }),
    svg("text", { x: width - right + 6, y: height - 10, class: "unit" }, unit),
    svg("path", { d: path, class: "found" }), marks,
    coverage.counted === null || coverage.counted === undefined ? null : svg("g", { class: good ? "counted" : "counted missing" },
      svg("line", { x1: width - right, x2: width - right, y1: y(0), y2: y(coverage.counted) }),
      svg("text", { x: width - right + 6, y: y(coverage.counted) + 4 }, `${coverage.counted} counted`)),
    svg("text", { x: left - 6, y: y(0) + 4, "text-anchor": "end" }, "0"));
}

export function certificate(coverage: Coverage, modes: readonly Mode[], unit: Unit): HTMLElement {
  return el("section", { class: "certificate" }, el("h3", {}, "Certificate"),
    el("p", {}, el("strong", { class: coverage.status === "complete" ? "good" : "doubtful" }, coverage.status.replace("_", " ")), ": ",
      number(coverage.found), " found, ", coverage.counted === null ? "none" : number(coverage.counted), " counted in [",
      frequency(coverage.window[0], unit), ", ", coverage.window[1] === null ? "∞" : frequency(coverage.window[1], unit), `) ${unit}: `,
      coverage.reason ? coverage.reason : coverages[coverage.status] ?? "", "."),
    modes.length > 0 ? el("figure", {}, countsPicture(coverage, modes, unit),
      el("figcaption", {}, "Modes on the frequency axis (long marks: negative energy) and their number; at the right end what the inertia of H(ω) counts.")) : null);
}
