// Curves over one variable: uPlot, with the keyboard, a tooltip, and pictures to take away.
import uPlot from "uplot";
import { announce, el, fresh } from "../dom";
import { text } from "../numbers";
import { colour, dash, onTheme, themed } from "./colours";
import { svgOf } from "./svg";

export interface Curve {
  name: string;
  values: readonly (number | null)[];
  colour?: string;
  dash?: number[];
  width?: number;
  points?: boolean;
  /** Lines that are no result: excitations, borders. */
  guide?: boolean;
}

export interface Plot {
  title: string;
  x: readonly number[];
  xName: string;
  yName: string;
  curves: Curve[];
  logarithmic?: boolean;
  xLogarithmic?: boolean;
  height?: number;
  /** What is said of a point of a curve. */
  tell?: (curve: number, point: number) => string;
  choose?: (curve: number, point: number) => void;
}

export class Chart {
  readonly element: HTMLElement;
  private plot: uPlot | null = null;
  private readonly place = el("div", { class: "canvas", tabindex: 0, role: "application" });
  private readonly legend = el("ul", { class: "legend", "aria-label": "curves" });
  private readonly tip = el("div", { class: "tip", hidden: true });
  private curve = 0;
  private point = 0;

  constructor(private of: Plot) {
    this.place.id = fresh("chart");
    this.place.setAttribute("aria-label", `${of.title}. Arrow keys: left and right along a curve, up and down between curves${of.choose ? ", Enter to choose" : ""}.`);
    const take = (kind: "png" | "svg") => el("button", { type: "button", onclick: () => this.download(kind) }, kind.toUpperCase());
    this.element = el("figure", { class: "chart" }, el("div", { class: "tools" },
      el("button", { type: "button", onclick: () => this.plot?.setData(this.plot.data, true) }, "Whole range"), take("svg"), take("png")),
      el("div", { class: "stage" }, this.place, this.tip), this.legend, el("figcaption", {}, of.title));
    this.place.addEventListener("keydown", (e) => this.key(e));
    onTheme(() => this.draw());
    new ResizeObserver(() => this.resize()).observe(this.place);
  }

  /** Other curves on the same axes. */
  show(curves: Curve[]): void {
    this.of = { ...this.of, curves };
    this.draw();
  }

  private data(): uPlot.AlignedData {
    return [this.of.x, ...this.of.curves.map((c) => c.values)] as unknown as uPlot.AlignedData;
  }

  private size(): { width: number; height: number } {
    return { width: Math.max(260, this.place.clientWidth), height: this.of.height ?? 380 };
  }

  private resize(): void {
    if (!this.plot) this.draw();
    else if (this.plot.width !== this.size().width) this.plot.setSize(this.size());
  }

  private draw(): void {
    if (this.place.clientWidth === 0) return;
    this.plot?.destroy();
    const named = 24;
    this.legend.replaceChildren(...this.of.curves.slice(0, named).map((c, k) => el("li", {}, el("span", { class: "swatch", style: `background:${c.guide ? "var(--muted)" : c.colour ?? colour(k)}` }), c.name)),
      ...(this.of.curves.length > named ? [el("li", {}, `… ${this.of.curves.length - named} more`)] : []));
    const axis = (label: string): uPlot.Axis => ({ label, stroke: themed("--text"), grid: { stroke: themed("--grid"), width: 1 }, ticks: { stroke: themed("--grid"), width: 1 }, font: "12px system-ui", labelFont: "12px system-ui", values: (_, splits) => splits.map((v) => (v === null ? "" : text(v, 5))) });
    const { width, height } = this.size();
    this.plot = new uPlot({
      width, height, legend: { show: false }, pxAlign: 0,
      scales: { x: { time: false, ...(this.of.xLogarithmic ? { distr: 3 as const } : {}) }, y: this.of.logarithmic ? { distr: 3 as const } : {} },
      axes: [axis(this.of.xName), { ...axis(this.of.yName), size: 72 }],
      cursor: { focus: { prox: 24 }, drag: { x: true, y: false } },
      focus: { alpha: 0.35 },
      series: [{}, ...this.of.curves.map((c, k) => ({ pxAlign: 0,
        label: c.name, stroke: c.guide ? themed("--muted") : c.colour ?? colour(k), width: c.width ?? (c.guide ? 1 : 2),
        dash: c.dash ?? (c.guide ? [3, 4] : dash(k)), points: { show: c.points ?? false, size: 6 }, spanGaps: false,
      }))],
      hooks: {
        setSeries: [(_: uPlot, k: number | null) => { if (k !== null && k > 0) this.curve = k - 1; }],
        setCursor: [(u: uPlot) => this.hover(u)],
      },
    }, this.data(), this.place);
    this.plot.over.addEventListener("click", () => this.choose());
    this.plot.over.addEventListener("mouseleave", () => { this.tip.hidden = true; });
  }

  private hover(u: uPlot): void {
    const at = u.cursor.idx, top = u.cursor.top ?? -1;
    if (at === null || at === undefined || top < 0) return;
    this.point = at;
    let best = -1, nearest = 40;
    this.of.curves.forEach((c, k) => {
      const v = c.values[at];
      if (c.guide || v === null || v === undefined) return;
      const off = Math.abs(u.valToPos(v, "y") - top);
      if (off < nearest) { nearest = off; best = k; }
    });
    if (best < 0) { this.tip.hidden = true; return; }
    this.curve = best;
    this.say(u);
  }

  private say(u: uPlot, aloud = false): void {
    const c = this.of.curves[this.curve], v = c?.values[this.point], x = this.of.x[this.point];
    if (!c || v === null || v === undefined || x === undefined) return;
    const words = this.of.tell ? this.of.tell(this.curve, this.point) : `${c.name}: ${text(v)} at ${text(x)}`;
    this.tip.textContent = words;
    this.tip.hidden = false;
    const left = u.valToPos(x, "x") + u.over.offsetLeft, top = u.valToPos(v, "y") + u.over.offsetTop;
    this.tip.style.left = `${Math.min(left + 12, this.place.clientWidth - 200)}px`;
    this.tip.style.top = `${Math.max(0, top - 40)}px`;
    if (aloud) announce(words);
  }

  private key(e: KeyboardEvent): void {
    const u = this.plot, n = this.of.curves.length;
    if (!u || n === 0) return;
    const step = (d: number): void => {
      for (let k = 0; k < n; ++k) {
        this.curve = (this.curve + d + n) % n;
        if (!this.of.curves[this.curve]?.guide) return;
      }
    };
    if (e.key === "ArrowRight") this.point = Math.min(this.point + 1, this.of.x.length - 1);
    else if (e.key === "ArrowLeft") this.point = Math.max(this.point - 1, 0);
    else if (e.key === "ArrowUp") step(1);
    else if (e.key === "ArrowDown") step(-1);
    else if (e.key === "Enter" || e.key === " ") this.choose();
    else return;
    e.preventDefault();
    u.setSeries(this.curve + 1, { focus: true });
    this.say(u, true);
  }

  private choose(): void {
    if (this.of.curves[this.curve]?.values[this.point] != null) this.of.choose?.(this.curve, this.point);
  }

  private download(kind: "png" | "svg"): void {
    const canvas = this.plot?.ctx.canvas;
    if (!canvas) return;
    const href = kind === "png" ? canvas.toDataURL("image/png") : `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgOf(this.of))}`;
    el("a", { href, download: `${this.of.title.replace(/[^\p{L}\p{N}]+/gu, "-").slice(0, 60)}.${kind}` }).click();
  }
}
