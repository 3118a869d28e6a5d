// Tables that sort, filter, and go to the clipboard as CSV.
import { announce, el, fresh, type Child } from "../dom";

export interface Column<Row> {
  heading: string;
  /** Of the CSV. */
  key: string;
  cell: (row: Row) => Child;
  /** What is sorted by, and stands in the CSV. */
  value: (row: Row) => number | string | null | undefined;
}

const quoted = (v: number | string | null | undefined): string => {
  const s = v === null || v === undefined ? "" : String(v);
  return /[",\n]/.test(s) ? `"${s.replaceAll('"', '""')}"` : s;
};

async function copy(csv: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(csv);
  } catch {
    const area = el("textarea", { "aria-hidden": "true", class: "offscreen" }, csv);
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
}

const few = 200;

export function table<Row>(caption: string, columns: Column<Row>[], rows: readonly Row[], options: { select?: (row: Row) => void } = {}): HTMLElement {
  let by = -1, down = false, words = "", all = rows.length <= few;
  const body = el("tbody");
  const shown = (): Row[] => {
    const kept = rows.filter((r) => words === "" || columns.some((c) => String(c.value(r) ?? "").toLowerCase().includes(words)));
    const column = columns[by];
    if (column) {
      const rank = (r: Row) => column.value(r) ?? "";
      kept.sort((a, b) => {
        const x = rank(a), y = rank(b);
        const order = typeof x === "number" && typeof y === "number" ? x - y : String(x).localeCompare(String(y));
        return down ? -order : order;
      });
    }
    return kept;
  };
  const more = el("button", { type: "button", class: "more", onclick: () => { all = true; fill(); } });
  const fill = (): void => {
    const kept = shown();
    const part = all ? kept : kept.slice(0, few);
    body.replaceChildren(...part.map((r) => {
      const line = el("tr", {}, columns.map((c) => el("td", { class: typeof c.value(r) === "number" ? "number" : "" }, c.cell(r))));
      if (options.select) {
        const choose = (): void => {
          for (const other of body.children) other.removeAttribute("aria-selected");
          line.setAttribute("aria-selected", "true");
          options.select?.(r);
        };
        line.tabIndex = 0;
        line.addEventListener("click", choose);
        line.addEventListener("keydown", (e) => {
          if (e.key === "Enter" || e.key === " ") { e.preventDefault(); choose(); }
        });
      }
      return line;
    }));
    more.hidden = part.length === kept.length;
    more.textContent = `Show all ${kept.length} rows`;
    count.textContent = words === "" ? "" : `${kept.length} of ${rows.length}`;
  };
  const heads = columns.map((c, i) => {
    const button = el("button", { type: "button", onclick: () => {
      down = by === i ? !down : false;
      by = i;
      heads.forEach((h, k) => h.setAttribute("aria-sort", k === i ? (down ? "descending" : "ascending") : "none"));
      fill();
      announce(`sorted by ${c.heading}, ${down ? "descending" : "ascending"}`);
    } }, c.heading);
    const number = rows.some((r) => typeof c.value(r) === "number");
    return el("th", { scope: "col", "aria-sort": "none", class: number ? "number" : "" }, button);
  });
  const id = fresh("filter"), count = el("span", { class: "count", "aria-live": "polite" });
  const tools = el("div", { class: "tools" },
    el("label", { for: id }, "Filter "),
    el("input", { id, type: "search", oninput: (e: InputEvent) => { words = (e.target as HTMLInputElement).value.trim().toLowerCase(); fill(); } }),
    count,
    el("button", { type: "button", onclick: () => {
      const lines = [columns.map((c) => c.key).join(","), ...shown().map((r) => columns.map((c) => quoted(c.value(r))).join(","))];
      void copy(lines.join("\n") + "\n").then(() => announce(`${lines.length - 1} rows copied as CSV`));
    } }, "Copy as CSV"));
  fill();
  return el("div", { class: "table" }, rows.length > 5 ? tools : null,
    el("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": caption },
      el("table", {}, el("caption", {}, caption), el("thead", {}, el("tr", {}, heads)), body)), more);
}

/** Two columns: what, and its value. */
export function facts(rows: [string, Child][]): HTMLElement {
  return el("dl", { class: "facts" }, rows.map(([name, value]) => el("div", {}, el("dt", {}, name), el("dd", {}, value))));
}
