// The moving picture: three.js draws lines, discs and points of the outline as a mode moves them.
import { AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, Line, LineBasicMaterial, LineLoop, Mesh, MeshLambertMaterial, PerspectiveCamera, Points, PointsMaterial, Scene, Vector3, WebGLRenderer, AxesHelper, Group } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Geometry, Points as Displacements } from "../documents";
import { colour, onTheme, themed } from "../charts/colours";
import { displaced, extent, largestDisplacement } from "./outline";

const rim = 48;  // corners of a disc

/** A rigid disc by the two ends of a diameter: its centre, and its normal beside the axis z at rest. */
interface Disc { ends: [number, number]; radius: number; mesh: Mesh }

export interface Motion {
  displacements: Displacements;
  omega: number;
  /** Of growing motions, 1/s. */
  growth?: number;
}

// Some of the points, in order, as those of a line.
function put(positions: Float32Array, of: readonly number[], geometry: BufferGeometry): void {
  const to = geometry.getAttribute("position") as BufferAttribute;
  of.forEach((i, k) => to.setXYZ(k, positions[3 * i] ?? 0, positions[3 * i + 1] ?? 0, positions[3 * i + 2] ?? 0));
  to.needsUpdate = true;
}

export class MovingScene {
  readonly canvas = document.createElement("canvas");
  /** Positions of all points of the outline as they are drawn, x, y, z one after the other. */
  readonly positions: Float32Array;
  amplitude = 0.15;
  phase = 0;
  fixedAxes = false;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly turning = new Group();
  private readonly camera = new PerspectiveCamera(35, 1.6, 0.01, 1e6);
  private readonly controls: OrbitControls;
  private readonly lines: { geometry: BufferGeometry; of: number[] }[] = [];
  private readonly discs: Disc[] = [];
  private readonly size: number;
  private readonly centre: Vector3;
  private orbitsOf: number[] = [];
  private readonly orbits = new Group();
  private readonly pale = new Group();
  private motion: Motion | null = null;
  private other: Motion | null = null;
  private wanted = 0;

  constructor(private readonly outline: Geometry, private readonly spin: number | null) {
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    const { centre, size } = extent(outline);
    this.size = size;
    this.centre = new Vector3(...centre);
    this.positions = new Float32Array(3 * outline.points.length);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.target.copy(this.centre);
    this.controls.addEventListener("change", () => this.draw());
    this.scene.add(new AmbientLight(0xffffff, 1.6), this.light(1, 1, 2), this.light(-2, -1, 1), this.turning);
    const axes = new AxesHelper(0.35 * size);
    this.turning.add(axes, this.orbits, this.pale);
    outline.lines.forEach((line, k) => this.add(line.name, line.points, k));
    this.view("oblique");
    onTheme(() => this.draw());
  }

  private light(x: number, y: number, z: number): DirectionalLight {
    const l = new DirectionalLight(0xffffff, 1.4);
    l.position.set(x, y, z);
    return l;
  }

  private add(name: string, of: number[], k: number): void {
    const rest = new BufferGeometry();
    rest.setAttribute("position", new BufferAttribute(new Float32Array(of.flatMap((i) => this.outline.points[i] ?? [0, 0, 0])), 3));
    if (of.length > 1) this.turning.add(new Line(rest, new LineBasicMaterial({ color: 0x999999, transparent: true, opacity: 0.55 })));
    if (name.startsWith("disk") && of.length === 2) { this.addDisc(of as [number, number], k); return; }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * of.length), 3));
    this.lines.push({ geometry, of });
    const paint = new Color(colour(k));
    if (of.length > 1) this.turning.add(new Line(geometry, new LineBasicMaterial({ color: paint })));
    if (name === "shaft") this.orbitsOf = of.filter((_, i) => i % Math.max(1, Math.floor(of.length / 12)) === 0);
    const ends = new BufferGeometry();  // tip masses, bearings
    ends.setAttribute("position", geometry.getAttribute("position"));
    ends.setIndex(name === "body" || name === "shaft" ? [] : [of.length - 1]);
    this.turning.add(new Points(ends, new PointsMaterial({ color: paint, size: 9, sizeAttenuation: false })));
  }

  private addDisc(ends: [number, number], k: number): void {
    const a = new Vector3(...(this.outline.points[ends[0]] as [number, number, number])), b = new Vector3(...(this.outline.points[ends[1]] as [number, number, number]));
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * (rim + 1)), 3));
    geometry.setIndex([...Array(rim).keys()].flatMap((i) => [0, i + 1, ((i + 1) % rim) + 1]));
    const mesh = new Mesh(geometry, new MeshLambertMaterial({ color: new Color(colour(k)), side: DoubleSide, transparent: true, opacity: 0.75 }));
    this.turning.add(mesh);
    const edge = new BufferGeometry();
    edge.setAttribute("position", geometry.getAttribute("position"));
    edge.setIndex([...Array(rim).keys()].map((i) => i + 1));
    this.turning.add(new LineLoop(edge, new LineBasicMaterial({ color: new Color(colour(k)) })));
    this.discs.push({ ends, radius: 0.5 * a.distanceTo(b), mesh });
  }

  /** A second mode beside the first, pale, at the same phase. */
  beside(motion: Motion | null): void {
    this.other = motion;
    this.draw();
  }

  private drawOther(): void {
    this.pale.visible = this.other !== null;
    const m = this.other;
    if (!m) return;
    if (this.pale.children.length === 0) {
      for (const l of this.lines) {
        const g = new BufferGeometry();
        g.setAttribute("position", new BufferAttribute(new Float32Array(3 * l.of.length), 3));
        this.pale.add(new Line(g, new LineBasicMaterial({ color: new Color(colour(3)), transparent: true, opacity: 0.6 })));
      }
    }
    const at = new Float32Array(this.positions.length);
    displaced(this.outline.points, m.displacements, (this.amplitude * this.size) / largestDisplacement(m.displacements), m.omega > 0 ? this.phase : 0, at);
    this.lines.forEach((l, q) => put(at, l.of, (this.pale.children[q] as Line).geometry));
  }

  show(motion: Motion): void {
    this.motion = motion;
    this.draw();
  }

  // The paths of some places of a shaft, a period long.
  private drawOrbits(m: Motion, scale: number): void {
    const steps = 48;
    while (this.orbits.children.length < this.orbitsOf.length) {
      const path = new BufferGeometry();
      path.setAttribute("position", new BufferAttribute(new Float32Array(3 * steps), 3));
      this.orbits.add(new LineLoop(path, new LineBasicMaterial({ color: new Color(colour(5)), transparent: true, opacity: 0.8 })));
    }
    this.orbitsOf.forEach((i, k) => {
      const to = (this.orbits.children[k] as LineLoop).geometry.getAttribute("position") as BufferAttribute;
      const at = this.outline.points[i] ?? [0, 0, 0], re = m.displacements.re[i] ?? [0, 0, 0], im = m.displacements.im[i] ?? [0, 0, 0];
      for (let s = 0; s < steps; ++s) {
        const c = scale * Math.cos((2 * Math.PI * s) / steps), d = scale * Math.sin((2 * Math.PI * s) / steps);
        to.setXYZ(s, ...([0, 1, 2].map((q) => (at[q] ?? 0) + c * (re[q] ?? 0) - d * (im[q] ?? 0)) as [number, number, number]));
      }
      to.needsUpdate = true;
    });
  }

  view(from: "x" | "y" | "z" | "oblique"): void {
    const d = 3.4 * this.size, at: Record<string, [number, number, number]> = { x: [d, 0, 0], y: [0, -d, 0], z: [0, -1e-3 * d, d], oblique: [0.62 * d, -0.62 * d, 0.48 * d] };
    this.camera.up.set(0, 0, 1);
    this.camera.position.copy(this.centre).add(new Vector3(...(at[from] ?? [d, d, d])));
    this.controls.update();
    this.draw();
  }

  resize(width: number, height: number): void {
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** Once in the next frame, however often it is asked for. */
  draw(): void {
    if (this.wanted) return;
    this.wanted = requestAnimationFrame(() => { this.wanted = 0; this.drawNow(); });
  }

  drawNow(): void {
    this.scene.background = new Color(themed("--panel") || "#ffffff");
    if (this.motion) {
      const m = this.motion, grown = m.growth && m.omega > 0 ? Math.exp((m.growth * this.phase) / m.omega) : m.growth ? Math.exp(this.phase) : 1;
      const scale = (Math.min(grown, 6) * this.amplitude * this.size) / largestDisplacement(m.displacements);
      displaced(this.outline.points, m.displacements, scale, m.omega > 0 ? this.phase : 0, this.positions);
      for (const l of this.lines) put(this.positions, l.of, l.geometry);
      for (const d of this.discs) this.turnDisc(d);
      if (!m.growth) this.drawOrbits(m, scale);
      this.orbits.visible = !m.growth;
      this.drawOther();
      this.turning.rotation.z = this.fixedAxes && this.spin !== null && m.omega > 0 ? (this.spin / m.omega) * this.phase : 0;
    }
    this.renderer.render(this.scene, this.camera);
  }

  // The diameter given tilts about one axis; about the other the disc stays across the axis of the rotor.
  private turnDisc(d: Disc): void {
    const p = (i: number): Vector3 => new Vector3(this.positions[3 * i] ?? 0, this.positions[3 * i + 1] ?? 0, this.positions[3 * i + 2] ?? 0);
    const a = p(d.ends[0]), b = p(d.ends[1]), middle = a.clone().add(b).multiplyScalar(0.5);
    const one = a.clone().sub(middle).normalize(), two = new Vector3(0, 0, 1).cross(one).normalize();
    const to = d.mesh.geometry.getAttribute("position") as BufferAttribute;
    to.setXYZ(0, middle.x, middle.y, middle.z);
    for (let k = 0; k < rim; ++k) {
      const angle = (2 * Math.PI * k) / rim, q = middle.clone().addScaledVector(one, d.radius * Math.cos(angle)).addScaledVector(two, d.radius * Math.sin(angle));
      to.setXYZ(k + 1, q.x, q.y, q.z);
    }
    to.needsUpdate = true;
    d.mesh.geometry.computeVertexNormals();
  }
}
