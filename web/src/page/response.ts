// Motion over time, and steady motion over frequencies or speeds.
import { el } from "../dom";
import type { AnyDocument, Unit } from "../documents";
import { inUnit, number, frequency } from "../numbers";
import { Chart, type Curve } from "../charts/plot";
import { most } from "../charts/scale";
import { table } from "./table";

/** Boxes that choose which curves are drawn; the largest ones are at first. */
function chooser(names: readonly string[], sizes: readonly number[], changed: (chosen: number[]) => void): { element: HTMLElement; chosen: number[] } {
  const atFirst = 4;
  const order = [...names.keys()].sort((a, b) => (sizes[b] ?? 0) - (sizes[a] ?? 0)).slice(0, atFirst);
  const chosen = new Set(order);
  const list = (): number[] => [...chosen].sort((a, b) => a - b);
  const element = el("fieldset", { class: "chooser" }, el("legend", {}, "Coordinates"), names.slice(0, 200).map((n, k) =>
    el("label", {}, el("input", { type: "checkbox", checked: chosen.has(k), onchange: (e: Event) => {
      if ((e.target as HTMLInputElement).checked) chosen.add(k);
      else chosen.delete(k);
      changed(list());
    } }), n)));
  return { element, chosen: list() };
}

const largest = (values: readonly (number | null)[]): number => Math.max(0, most(values.map((v) => Math.abs(v ?? 0))));

interface OverTime { t: number[]; q: number[][]; labels: string[]; remark?: string; modal?: { omega: number; amplitude: number; phase: number; energy: number }[] }

export function motionPage(document: AnyDocument, unit: Unit): HTMLElement[] {
  const d = document as unknown as OverTime & AnyDocument;
  const curve = (k: number): Curve => ({ name: d.labels[k] ?? "", values: d.q.map((row) => row[k] ?? null) });
  const pick = chooser(d.labels, d.labels.map((_, k) => largest(d.q.map((row) => row[k] ?? 0))), (chosen) => chart.show(chosen.map(curve)));
  const chart: Chart = new Chart({ title: `Motion of ${d.model.title}`, x: d.t, xName: "t [s]", yName: "q", curves: pick.chosen.map(curve) });
  const modal = (d.modal ?? []).map((m, k) => ({ place: k + 1, ...m }));
  return [el("section", {}, el("h3", {}, "Motion over time"), pick.element, chart.element, d.remark ? el("p", { class: "remark" }, d.remark) : null),
    ...(modal.length > 0 ? [table("The motion mode by mode", [
      { heading: "#", key: "mode", cell: (m) => m.place, value: (m) => m.place },
      { heading: `ω [${unit}]`, key: "omega", cell: (m) => frequency(m.omega, unit), value: (m) => m.omega },
      { heading: "amplitude", key: "amplitude", cell: (m) => number(m.amplitude), value: (m) => m.amplitude },
      { heading: "phase [rad]", key: "phase", cell: (m) => number(m.phase), value: (m) => m.phase },
      { heading: "energy", key: "energy", cell: (m) => number(m.energy), value: (m) => m.energy },
    ], modal)] : [])];
}

interface Point { omega?: number; speed?: number; re?: number[]; im?: number[]; major?: number[]; resonance: boolean }

export function sweepPage(document: AnyDocument, unit: Unit): HTMLElement[] {
  const d = document as unknown as { labels: string[]; points: Point[]; places?: { name: string }[]; modes?: Driven[]; critical_speeds?: Driven[] } & AnyDocument;
  interface Driven { omega: number; error_bound?: number; driven: string; participation: number }
  const x = d.points.map((p) => inUnit(p.omega ?? p.speed ?? 0, unit));
  const amplitude = (k: number): (number | null)[] => d.points.map((p) => (p.resonance || !p.re || p.re[k] === undefined ? null : Math.hypot(p.re[k] ?? 0, p.im?.[k] ?? 0) || null));
  const phase = (k: number): (number | null)[] => d.points.map((p) => (p.resonance || !p.re || !(p.re[k] || p.im?.[k]) ? null : (Math.atan2(p.im?.[k] ?? 0, p.re[k] ?? 0) * 180) / Math.PI));
  const both = (chosen: number[]): [Curve[], Curve[]] => [chosen.map((k) => ({ name: d.labels[k] ?? "", values: amplitude(k) })), chosen.map((k) => ({ name: d.labels[k] ?? "", values: phase(k) }))];
  const pick = chooser(d.labels, d.labels.map((_, k) => largest(amplitude(k))), (chosen) => {
    const [a, p] = both(chosen);
    size.show(a);
    angle.show(p);
  });
  const [a, p] = both(pick.chosen);
  const name = d.points[0]?.speed === undefined ? `frequency [${unit}]` : `speed [${unit}]`;
  const size: Chart = new Chart({ title: `Amplitude of ${d.model.title}`, x, xName: name, yName: "|q|", curves: a, logarithmic: true });
  const angle: Chart = new Chart({ title: "Phase", x, xName: name, yName: "phase [°]", curves: p, height: 220 });
  const poles = d.modes ?? d.critical_speeds ?? [];
  return [el("section", {}, el("h3", {}, "Steady response"), pick.element, size.element, angle.element),
    ...(poles.length > 0 ? [table(d.modes ? "Modes of the range" : "Critical speeds of the range", [
      { heading: `ω [${unit}]`, key: "omega", cell: (m) => frequency(m.omega, unit), value: (m) => m.omega },
      { heading: "driven", key: "driven", cell: (m) => m.driven, value: (m) => m.driven },
      { heading: "participation", key: "participation", cell: (m) => number(m.participation, 4), value: (m) => m.participation },
    ], poles)] : [])];
}
