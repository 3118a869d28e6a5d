// Campbell diagram: branches over the spin, lines of excitation by a control, what a branch is at a spin.
import { el, fresh } from "../dom";
import type { CampbellDocument, Unit } from "../documents";
import { frequency, inUnit, number, text } from "../numbers";
import { spoken, verdicts } from "../words";
import { Chart, type Curve } from "../charts/plot";
import { most } from "../charts/scale";
import { table } from "./table";

export function campbellPage(d: CampbellDocument, unit: Unit): HTMLElement[] {
  const x = d.spins.map((s) => inUnit(s, unit));
  const branches: Curve[] = d.branches.map((b, k) => ({ name: `branch ${k + 1}`, values: b.omega.map((w) => (w === null ? null : inUnit(w, unit))) }));
  const orders = new Set(d.excitation.map((e) => e.order));
  if (orders.size === 0) orders.add(1);
  const highest = Math.max(0, most(branches.flatMap((b) => b.values.map((v) => v ?? 0))));
  const guides = (): Curve[] => [...orders].sort((a, b) => a - b).map((m) => ({ name: `order ${m}`, guide: true, values: x.map((s) => (m * s <= 1.05 * highest ? m * s : null)) }));
  const chosen = el("div", { class: "chosen", "aria-live": "polite" }, el("p", {}, "Choose a point of a branch to see what it is there."));
  const chart = new Chart({
    title: `Campbell diagram of ${d.model.title}`, x, xName: `spin [${unit}]`, yName: unit === "rad/s" ? "ω [rad/s]" : `f [${unit}]`, curves: [...branches, ...guides()],
    tell: (k, i) => {
      const b = d.branches[k];
      return `branch ${k + 1}: ${text(branches[k]?.values[i] ?? NaN, 7)} ${unit} at ${text(x[i] ?? 0, 6)}, ${b?.whirl[i] ?? "no whirl"}${b?.slope?.[i] != null ? `, dω/dΩ ${text(b.slope[i] ?? 0, 3)}` : ""}`;
    },
    choose: (k, i) => {
      const b = d.branches[k];
      if (!b) return;
      chosen.replaceChildren(el("h4", {}, `Branch ${k + 1}`), el("dl", { class: "facts" }, [
        ["spin", frequency(d.spins[i], unit)], ["frequency", frequency(b.omega[i], unit)], ["whirl", b.whirl[i] ?? "–"], ["energy sign", number(b.energy_sign[i])],
        ["dω/dΩ", number(b.slope?.[i], 5)], ["error bound [rad/s]", number(b.error_bound?.[i], 2)], ["coverage at this spin", d.coverage[i] ?? "–"],
      ].map(([n, v]) => el("div", {}, el("dt", {}, n as string), el("dd", {}, v as Node)))));
    },
  });
  const id = fresh("orders");
  const control = el("div", { class: "tools" }, el("label", { for: id }, "Excitation orders "),
    el("input", { id, type: "text", inputmode: "decimal", value: [...orders].join(", "), onchange: (e: Event) => {
      orders.clear();
      for (const word of (e.target as HTMLInputElement).value.split(/[\s,;]+/)) {
        const m = Number(word);
        if (word !== "" && Number.isFinite(m)) orders.add(m);
      }
      chart.show([...branches, ...guides()]);
    } }));
  const verdictsSeen = [...new Set(d.stability)];
  const parts: HTMLElement[] = [
    el("section", { class: "campbell" }, el("h3", {}, "Frequencies over the spin"), control, chart.element, chosen,
      el("p", {}, `Verdict over these spins: ${verdictsSeen.map((s) => verdicts[s] ?? s).join(", then ")}. `,
        d.coverage.every((c) => c === "complete") ? "Every spin is certified complete." : "Not every spin is certified complete.")),
  ];
  if (d.events.length > 0) parts.push(table("Where branches meet", [
    { heading: "kind", key: "kind", cell: (e) => spoken(e.kind), value: (e) => e.kind },
    { heading: `spin [${unit}]`, key: "spin", cell: (e) => frequency(e.spin, unit), value: (e) => e.spin },
    { heading: "branches", key: "branches", cell: (e) => e.branches.map((b) => b + 1).join(" and "), value: (e) => e.branches.map((b) => b + 1).join(" ") },
    { heading: `gap [${unit}]`, key: "gap", cell: (e) => frequency(e.gap, unit, 5), value: (e) => e.gap },
  ], d.events));
  if (d.excitation.length > 0) parts.push(table("Intersections with excitations", [
    { heading: "order", key: "order", cell: (e) => number(e.order), value: (e) => e.order },
    { heading: `spin [${unit}]`, key: "spin", cell: (e) => frequency(e.spin, unit), value: (e) => e.spin },
    { heading: `frequency [${unit}]`, key: "omega", cell: (e) => frequency(e.omega, unit), value: (e) => e.omega },
    { heading: "branch", key: "branch", cell: (e) => e.branch + 1, value: (e) => e.branch + 1 },
    { heading: "whirl", key: "whirl", cell: (e) => e.whirl ?? "–", value: (e) => e.whirl },
  ], d.excitation));
  return parts;
}
