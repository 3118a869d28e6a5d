// Critical speeds, and their map over a number of the model.
import { el } from "../dom";
import type { CriticalDocument, CriticalSpeed, Unit } from "../documents";
import { digitsOf, frequency, inUnit, number } from "../numbers";
import { Chart } from "../charts/plot";
import { certificate } from "./certificate";
import { entries } from "./entries";
import { tornado } from "./modes";
import { table } from "./table";

export function criticalPage(d: CriticalDocument, unit: Unit): HTMLElement[] {
  const parts: HTMLElement[] = [];
  const heading = `Critical speeds of order ${d.order}`;
  if (d.map && d.map.length > 0) {
    const most = Math.max(...d.map.map((m) => m.critical_speeds.length));
    const curves = Array.from({ length: most }, (_, k) => ({
      name: `critical speed ${k + 1}`, values: (d.map ?? []).map((m) => { const c = m.critical_speeds[k]; return c ? inUnit(c.omega, unit) : null; }),
    }));
    parts.push(el("section", {}, el("h3", {}, "Critical-speed map"), new Chart({ title: `${heading} over ${d.over ?? "a number"}`, x: d.map.map((m) => m.value), xName: d.over ?? "", yName: `critical speed [${unit}]`, curves, logarithmic: true, xLogarithmic: true }).element));
  }
  if (d.critical_speeds) {
    const rows = d.critical_speeds.map((speed, k) => ({ place: k, speed }));
    const drawer = el("div", { class: "beside", "aria-live": "polite" });
    parts.push(el("section", {}, table(heading, [
      { heading: "#", key: "place", cell: (r) => r.place + 1, value: (r) => r.place + 1 },
      { heading: `Ω [${unit}]`, key: "omega", cell: (r: { speed: CriticalSpeed }) => frequency(r.speed.omega, unit, digitsOf(r.speed.omega, r.speed.error_bound)), value: (r) => r.speed.omega },
      { heading: "rpm", key: "rpm", cell: (r) => number(r.speed.rpm, digitsOf(r.speed.omega, r.speed.error_bound)), value: (r) => r.speed.rpm },
      { heading: "whirl", key: "whirl", cell: (r) => r.speed.whirl ?? "–", value: (r) => r.speed.whirl },
      { heading: "residual", key: "residual", cell: (r) => number(r.speed.residual, 2), value: (r) => r.speed.residual },
    ], rows, { select: (r) => drawer.replaceChildren(el("h4", {}, `Critical speed ${r.place + 1}`), ...[d.sensitivity ? tornado(d.sensitivity, r.place) : null, r.speed.shape ? entries(r.speed.shape) : null].filter((e): e is HTMLElement => e !== null)) }), drawer));
  }
  if (d.coverage) parts.push(certificate(d.coverage, (d.critical_speeds ?? []).map((c) => ({ omega: c.omega, kind: "vibration", energy_sign: 1 })), unit));
  return parts;
}
