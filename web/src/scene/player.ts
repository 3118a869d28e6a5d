// The moving picture with its controls: which mode, play and pause, phase, amplitude, from where, in which axes.
import { announce, el, fresh } from "../dom";
import type { ModesDocument, Points, Shape, Unit } from "../documents";
import { inUnit, text } from "../numbers";
import { spoken } from "../words";
import { bodyMoved, boxOf, withBody } from "./body";
import { MovingScene, type Motion } from "./scene";

interface Choice { name: string; motion: Motion; place?: number }

function choices(d: ModesDocument, unit: Unit, box: number[] | null): Choice[] {
  const all: Choice[] = [];
  const moved = (of: { shape?: Shape; displacements?: Points }): Points => (box && of.shape && of.displacements ? bodyMoved(of.shape, box, of.displacements) : of.displacements ?? { re: [], im: [] });
  d.modes.forEach((m, k) => {
    if (m.displacements) all.push({ name: `${k + 1}: ${text(inUnit(m.omega, unit), 6)} ${unit}${m.name ? `, ${m.name}` : m.whirl ? `, ${m.whirl}` : ""}`, motion: { displacements: moved(m), omega: m.omega }, place: k });
  });
  d.unstable.forEach((u, k) => {
    if (u.displacements) all.push({ name: `growing ${k + 1}: ${spoken(u.kind)}, ${text(u.growth_rate, 5)} 1/s`, motion: { displacements: moved(u), omega: u.omega, growth: u.growth_rate } });
  });
  return all;
}

const seconds = 2.4;  // a period takes on the screen

export class Player {
  readonly element: HTMLElement;
  private scene: MovingScene | null = null;
  private playing = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  private last = 0;
  private readonly all: Choice[];
  private readonly menu: HTMLSelectElement;
  private readonly slider: HTMLInputElement;
  private readonly button: HTMLButtonElement;

  constructor(d: ModesDocument, unit: Unit) {
    const box = boxOf(d), rest = { points: d.geometry?.points ?? [], lines: d.geometry?.lines ?? [] };
    this.all = choices(d, unit, box);
    const turning = d.model.frame === "turning", spin = typeof d.parameters?.["spin"] === "number" ? d.parameters["spin"] : null;
    const stage = el("div", { class: "stage scene" });
    const control = (name: string, make: (id: string) => HTMLElement): HTMLElement => { const id = fresh("scene"); return el("span", { class: "control" }, el("label", { for: id }, name), make(id)); };
    this.button = el("button", { type: "button", onclick: () => this.play(!this.playing) });
    this.slider = el("input", { type: "range", min: 0, max: 360, step: 1, value: 0, oninput: () => { this.play(false); this.setPhase((Number(this.slider.value) * Math.PI) / 180); } });
    this.menu = el("select", { onchange: () => this.choose(this.menu.selectedIndex) }, this.all.map((c) => el("option", {}, c.name)));
    const menuControl = control("Mode", (id) => { this.menu.id = id; return this.menu; });
    const other = control("beside", (id) => el("select", { id, onchange: (e: Event) => this.scene?.beside(this.all[(e.target as HTMLSelectElement).selectedIndex - 1]?.motion ?? null) },
      el("option", {}, "none"), this.all.map((c) => el("option", {}, c.name))));
    this.element = el("figure", { class: "moving" }, stage, el("div", { class: "tools" }, menuControl, other, this.button,
      control("Phase", (id) => { this.slider.id = id; return this.slider; }),
      control("Amplitude", (id) => el("input", { id, type: "range", min: 0, max: 0.5, step: 0.01, value: 0.15, oninput: (e: Event) => { if (this.scene) { this.scene.amplitude = Number((e.target as HTMLInputElement).value); this.scene.draw(); } } })),
      el("span", { class: "control", role: "group", "aria-label": "View from" }, (["oblique", "x", "y", "z"] as const).map((v) => el("button", { type: "button", "aria-label": `view from ${v}`, onclick: () => this.scene?.view(v) }, v))),
      turning && spin !== null ? control("Fixed axes", (id) => el("input", { id, type: "checkbox", onchange: (e: Event) => { if (this.scene) { this.scene.fixedAxes = (e.target as HTMLInputElement).checked; this.scene.draw(); } } })) : null),
    el("figcaption", {}, "Grey: at rest. Drag to turn, wheel to come nearer. Motion is Re(X exp jωt), slowed down."));
    try {
      this.scene = new MovingScene(box ? withBody(rest, box) : rest, spin);
    } catch {
      stage.append(el("p", {}, "This browser has no WebGL: modes cannot be shown moving."));
      return;
    }
    const canvas = this.scene.canvas;
    canvas.setAttribute("role", "img");
    stage.append(canvas);
    (canvas as HTMLCanvasElement & { scene?: MovingScene }).scene = this.scene;
    new ResizeObserver(() => this.scene?.resize(stage.clientWidth, Math.max(240, Math.min(460, 0.62 * stage.clientWidth)))).observe(stage);
    const first = this.all.findIndex((c) => c.motion.omega > 0);
    this.choose(Math.max(0, first));
    this.play(this.playing);
    requestAnimationFrame((t) => this.frame(t));
  }

  /** By the place of the mode in the document; nothing changes where that has no picture. */
  chooseMode(place: number): void {
    const k = this.all.findIndex((c) => c.place === place);
    if (k >= 0) this.choose(k);
  }

  private choose(k: number): void {
    const c = this.all[k];
    if (!c || !this.scene) return;
    this.menu.selectedIndex = k;
    this.scene.canvas.setAttribute("aria-label", `moving picture of mode ${c.name}`);
    this.setPhase(0);
    this.scene.show(c.motion);
  }

  private play(on: boolean): void {
    this.playing = on;
    this.button.textContent = on ? "Pause" : "Play";
    announce(on ? "playing" : "paused");
  }

  private setPhase(phase: number): void {
    if (!this.scene) return;
    this.scene.phase = phase;
    this.slider.value = String(Math.round(((phase * 180) / Math.PI) % 360));
    this.scene.draw();
  }

  private frame(t: number): void {
    const passed = Math.min(0.1, (t - this.last) / 1000);
    this.last = t;
    if (this.playing && this.scene && document.visibilityState === "visible") {
      const motion = this.all[this.menu.selectedIndex]?.motion;
      let phase = this.scene.phase + (2 * Math.PI * passed) / seconds;
      if (motion?.growth && phase > 4 * Math.PI) phase = 0;  // growing motions begin again
      this.setPhase(phase);
    }
    requestAnimationFrame((next) => this.frame(next));
  }
}
