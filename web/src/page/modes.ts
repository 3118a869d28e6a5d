// The table of modes, what each rests on, and how much numbers of the model move it.
import { el, type Child } from "../dom";
import type { Mode, ModesDocument, Sensitivity, Unit } from "../documents";
import { digitsOf, frequency, number, percent } from "../numbers";
import { signs, spoken } from "../words";
import { table, type Column } from "./table";
import { bars } from "../charts/bars";

interface Row { place: number; mode: Mode }

function largestShare(m: Mode): [string, number] | null {
  const shares = Object.entries(m.participation?.kinetic ?? {});
  return shares.length === 0 ? null : shares.reduce((a, b) => (b[1] > a[1] ? b : a));
}

export function modesTable(d: ModesDocument, unit: Unit, select: (place: number) => void): HTMLElement {
  const rows: Row[] = d.modes.map((mode, k) => ({ place: k + 1, mode }));
  const some = (has: (m: Mode) => unknown): boolean => d.modes.some((m) => Boolean(has(m)));
  const columns: Column<Row>[] = [
    { heading: "#", key: "mode", cell: (r) => r.place, value: (r) => r.place },
    { heading: unit === "rad/s" ? "ω [rad/s]" : `f [${unit}]`, key: "omega", cell: (r) => frequency(r.mode.omega, unit, digitsOf(r.mode.omega, r.mode.error_bound)), value: (r) => r.mode.omega },
    { heading: "energy", key: "energy_sign", cell: (r) => el("span", { class: r.mode.energy_sign < 0 ? "negative" : "" }, signs(r.mode.energy_sign)), value: (r) => r.mode.energy_sign },
    { heading: "kind", key: "kind", cell: (r) => spoken(r.mode.kind), value: (r) => spoken(r.mode.kind) },
  ];
  if (unit !== "Hz") columns.splice(2, 0, { heading: "f [Hz]", key: "frequency_hz", cell: (r) => number(r.mode.frequency_hz, digitsOf(r.mode.omega, r.mode.error_bound)), value: (r) => r.mode.frequency_hz });
  if (some((m) => m.name)) columns.push({ heading: "name", key: "name", cell: (r) => r.mode.name ?? "", value: (r) => r.mode.name ?? "" });
  if (some((m) => m.whirl)) columns.push({ heading: "whirl", key: "whirl", cell: (r) => r.mode.whirl ?? "–", value: (r) => r.mode.whirl ?? "" });
  if (some((m) => m.fixed_axes?.length)) columns.push({ heading: `in fixed axes [${unit}]`, key: "omega_fixed", value: (r) => r.mode.fixed_axes?.[0]?.omega,
    cell: (r) => (r.mode.fixed_axes ?? []).filter((p) => p.share >= 0.01).map((p, i): Child => [i > 0 ? ", " : "", frequency(p.omega, unit, 6)]) });
  if (some((m) => m.participation)) columns.push({ heading: "most kinetic energy", key: "part", value: (r) => largestShare(r.mode)?.[0] ?? "",
    cell: (r) => { const s = largestShare(r.mode); return s ? [s[0], " ", percent(s[1])] : "–"; } });
  return table(`Modes of ${d.model.title}`, columns, rows, { select: (r) => select(r.place - 1) });
}

export function evidence(d: ModesDocument, unit: Unit): HTMLElement {
  return el("details", {}, el("summary", {}, "Evidence: residuals and error bounds"), table("What each mode rests on", [
    { heading: "#", key: "mode", cell: (r: Row) => r.place, value: (r: Row) => r.place },
    { heading: `ω [${unit}]`, key: "omega", cell: (r) => frequency(r.mode.omega, unit, 10), value: (r) => r.mode.omega },
    { heading: "residual", key: "residual", cell: (r) => number(r.mode.residual, 2), value: (r) => r.mode.residual },
    { heading: "error bound [rad/s]", key: "error_bound", cell: (r) => number(r.mode.error_bound, 2), value: (r) => r.mode.error_bound },
  ], d.modes.map((mode, k) => ({ place: k + 1, mode }))));
}

export function participation(m: Mode): HTMLElement | null {
  const shares = (["kinetic", "strain"] as const).flatMap((kind) => (m.participation?.[kind] ? [{ name: kind, of: m.participation[kind] }] : []));
  const names = [...new Set(shares.flatMap((s) => Object.keys(s.of)))].filter((n) => shares.some((s) => (s.of[n] ?? 0) > 1e-3)).slice(0, 24);
  if (names.length === 0) return null;
  return bars("Where the energy is", names, shares.map((s) => ({ name: s.name, values: names.map((n) => s.of[n] ?? 0) })), percent);
}

/** A tornado: by how many per cent a mode moves where a number moves by one, largest first. */
export function tornado(all: readonly Sensitivity[], place: number): HTMLElement | null {
  const rows = all.map((s) => ({ key: s.key, relative: s.relative[place] ?? null })).filter((r): r is { key: string; relative: number } => r.relative !== null && Math.abs(r.relative) > 1e-6);
  if (rows.length === 0) return null;
  rows.sort((a, b) => Math.abs(b.relative) - Math.abs(a.relative));
  const most = rows.slice(0, 16);
  return bars(`Sensitivity: % of ω for 1 % of the number`, most.map((r) => r.key), [{ name: "relative slope", values: most.map((r) => r.relative) }], (x) => number(x, 3));
}
