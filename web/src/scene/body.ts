// The body of a spacecraft as the homogeneous box that has its mass and moments of inertia, moved as it moves:
// ζ + θ × r of the coordinates zeta1 … theta3.
import type { Geometry, ModesDocument, Points, Shape } from "../documents";

const corners = [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]];
const round = [0, 1, 2, 3, 0, 4, 5, 1, 5, 6, 2, 6, 7, 3, 7, 4];  // every edge, by one line

/** Half the sides of the box; nothing where the document has no inertia. */
export function boxOf(d: ModesDocument): number[] | null {
  const p = d.parameters ?? {}, mass = p["body.mass"], inertia = [0, 1, 2].map((i) => p[`body.inertia[${i}]`]);
  if (d.model.kind !== "spacecraft" || !mass || inertia.some((i) => i === undefined)) return null;
  const [a = 0, b = 0, c = 0] = inertia as number[];
  return [b + c - a, c + a - b, a + b - c].map((s) => Math.sqrt(Math.max(0, 1.5 * s) / mass));
}

/** The outline with the box in front of it. */
export function withBody(g: Geometry, box: readonly number[]): Geometry {
  const points = corners.map((c) => c.map((s, i) => s * (box[i] ?? 0)));
  return { points: [...points, ...g.points], lines: [{ name: "body", points: round }, ...g.lines.map((l) => ({ name: l.name, points: l.points.map((k) => k + points.length) }))] };
}

/** How the corners move, in front of the displacements of the outline. */
export function bodyMoved(shape: Shape, box: readonly number[], of: Points): Points {
  const entry = (name: string, part: number[]): number => part[shape.labels?.indexOf(name) ?? -1] ?? 0;
  const moved = (part: number[]): number[][] => {
    const [z1, z2, z3, t1, t2, t3] = ["zeta1", "zeta2", "zeta3", "theta1", "theta2", "theta3"].map((n) => entry(n, part)) as [number, number, number, number, number, number];
    return corners.map((c) => {
      const [x, y, z] = c.map((s, i) => s * (box[i] ?? 0)) as [number, number, number];
      return [z1 + t2 * z - t3 * y, z2 + t3 * x - t1 * z, z3 + t1 * y - t2 * x];
    });
  };
  return { re: [...moved(shape.re), ...of.re], im: [...moved(shape.im), ...of.im] };
}
