// The page: every document that stands in it, one after the other.
import { announce, el, type Child } from "./dom";
import { kindOf, withShapes, type AnyDocument, type CountDocument, type ModesDocument, type Named, type Unit } from "./documents";
import { frequency, number } from "./numbers";
import { themeChanged } from "./charts/colours";
import { campbellPage } from "./page/campbell";
import { certificate } from "./page/certificate";
import { criticalPage } from "./page/critical";
import { evidence, modesTable, participation, tornado } from "./page/modes";
import { motionPage, sweepPage } from "./page/response";
import { stabilityPage } from "./page/stability";
import { structure, structurePage } from "./page/structure";
import { facts, table } from "./page/table";
import { unstable, verdict } from "./page/verdict";
import { Player } from "./scene/player";
import { entries } from "./page/entries";

function modesPage(given: ModesDocument, unit: Unit): Child[] {
  const d = withShapes(given);
  const moving = d.geometry && d.modes.some((m) => m.displacements) ? new Player(d, unit) : null;
  const beside = el("div", { class: "beside", "aria-live": "polite" });
  const select = (place: number): void => {
    moving?.chooseMode(place);
    const m = d.modes[place];
    if (!m) return;
    beside.replaceChildren(...[el("h4", {}, `Mode ${place + 1}`), participation(m), d.sensitivity ? tornado(d.sensitivity, place) : null, m.shape ? entries(m.shape) : null].filter((e): e is HTMLElement => e !== null));
  };
  select(Math.max(0, d.modes.findIndex((m) => m.omega > 0)));
  return [verdict(d.stability, d.index_balance), certificate(d.coverage, d.modes, unit),
    el("section", {}, el("h3", {}, "Modes"), el("div", { class: "two" }, moving?.element, el("div", {}, modesTable(d, unit, select))), beside),
    unstable(d.unstable, unit), structure(d.structure), evidence(d, unit)];
}

function countPage(d: CountDocument, unit: Unit): Child[] {
  return [el("section", {}, el("h3", {}, "Count"), facts([
    ["window", el("span", {}, "[", frequency(d.window[0], unit), ", ", d.window[1] === null ? "∞" : frequency(d.window[1], unit), `) ${unit}`)],
    ["modes", number(d.count)], ["status", d.status], ["signed count", number(d.signed)], ["zero modes", number(d.zero)],
    ["n₋(H) at the ends", el("span", {}, number(d.negative[0]), " and ", number(d.negative[1]))]]))];
}

const pages: Record<string, (d: never, unit: Unit) => Child[]> = {
  modes: modesPage, campbell: campbellPage, critical: criticalPage, stability: stabilityPage, structure: structurePage, count: countPage,
  response: motionPage, frequency_response: sweepPage, unbalance_response: sweepPage,
};
const titles: Record<string, string> = {
  modes: "Modes", campbell: "Campbell diagram", critical: "Critical speeds", stability: "Stability", structure: "Structure", count: "Count of modes",
  response: "Motion", frequency_response: "Response over frequency", unbalance_response: "Unbalance response",
};

function about(d: AnyDocument, name: string): HTMLElement {
  const asked = Object.entries(d.options ?? {}).map(([k, v]) => `--${k}${v === true || v === "" ? "" : ` ${typeof v === "string" ? v : JSON.stringify(v)}`}`).join(" ");
  const parameters = Object.entries(d.parameters ?? {});
  return el("details", { class: "about" }, el("summary", {}, "Model, versions and what was asked"), facts([
    ["document", el("span", {}, name, ", ", d.schema)], ["asked", asked || "nothing beside the model"], ...(d.timings?.at ? [["when", d.timings.at] as [string, Child]] : []),
    ["kind", d.model.kind ?? "–"], ["coordinates", number(d.model.coordinates)], ["frame", d.model.frame ?? "not said"], ["SHA-256 of the model", d.model.sha256 ?? "–"],
    ...Object.entries(d.versions ?? {}).map(([k, v]): [string, Child] => [k, v]),
    ...(d.timings?.solve_s === undefined ? [] : [["solved in [s]", number(d.timings.solve_s, 3)] as [string, Child]])]),
  parameters.length > 0 ? table("Numbers of the model", [
    { heading: "name", key: "name", cell: (p) => p[0], value: (p) => p[0] }, { heading: "value (SI)", key: "value", cell: (p) => number(p[1], 10), value: (p) => p[1] }], parameters) : null);
}

// A document that lacks what its kind has says so in its place; the others stand.
function made(make: (d: never, unit: Unit) => Child[], d: AnyDocument, unit: Unit): Child[] {
  try {
    return make(d as never, unit);
  } catch (e) {
    return [el("p", { class: "doubtful", role: "alert" }, `This document is damaged: ${e instanceof Error ? e.message : String(e)}`)];
  }
}

function page({ name, document: d }: Named, k: number): HTMLElement {
  const kind = kindOf(d), unit = d.units ?? "rad/s";
  const make = pages[kind];
  return el("article", { id: `document-${k + 1}`, class: kind }, el("header", {}, el("p", { class: "kind" }, titles[kind] ?? kind), el("h2", {}, d.model.title || name)),
    make ? made(make, d, unit) : el("p", {}, `This page knows no picture of documents of kind ${kind}.`), about(d, name));
}

function theme(): HTMLElement {
  const root = document.documentElement;
  const dark = (): boolean => (root.dataset["theme"] ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light")) === "dark";
  const button = el("button", { type: "button", class: "theme", onclick: () => {
    root.dataset["theme"] = dark() ? "light" : "dark";
    word();
    themeChanged();
    announce(`${root.dataset["theme"]} theme`);
  } });
  const word = (): void => { button.textContent = dark() ? "Light" : "Dark"; button.setAttribute("aria-label", `switch to ${dark() ? "light" : "dark"} theme`); };
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { word(); themeChanged(); });
  word();
  return button;
}

function begin(): void {
  const source = document.getElementById("documents");
  const all = JSON.parse(source?.textContent ?? "[]") as Named[];
  const main = document.querySelector("main");
  if (!main) return;
  const first = all[0]?.document.model.title;
  document.title = all.length === 1 ? `${titles[kindOf(all[0]!.document)] ?? ""}: ${first || all[0]!.name}` : `${all.length} results of gyromode`;
  const bar = el("header", { class: "bar" }, el("strong", {}, "gyromode"),
    all.length > 1 ? el("nav", { "aria-label": "documents" }, all.map((n, k) => el("a", { href: `#document-${k + 1}` }, `${titles[kindOf(n.document)] ?? kindOf(n.document)}: ${n.document.model.title || n.name}`))) : null,
    el("span", { class: "right" }, el("button", { type: "button", onclick: () => print() }, "Print"), theme()));
  main.before(bar);
  main.replaceChildren(...all.map(page));
  addEventListener("beforeprint", () => { for (const d of document.querySelectorAll("details:not(.licences)")) (d as HTMLDetailsElement).open = true; });
}

begin();
