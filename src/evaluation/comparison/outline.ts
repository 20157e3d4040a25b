import { firstEqualFloats } from '../../core/equal-tuples.ts';
import type { Mesh } from '../../core/mesh.ts';

type Triple = readonly [number, number, number];
type Surface = Pick<Mesh, 'positions' | 'indices'>;

/**
 * A closed line around a surface, which moves with it: corner i lies on the edge from vertex
 * `from[i]` to `to[i]`, at the part `parts[i]` of its way.
 */
export interface Outline {
  readonly from: readonly number[];
  readonly to: readonly number[];
  readonly parts: readonly number[];
}

/**
 * Cuts a surface by a plane. Vertices at one place count as one; lines that end at a hole are left
 * out.
 *
 * @param origin a point of the plane
 * @param normal of the plane, of any length
 */
export function cutOutlines(
  { positions, indices }: Surface,
  origin: Triple,
  normal: Triple,
): Outline[] {
  const first = firstEqualFloats(positions, 3);
  const heights = Float64Array.from(first, (vertex) => heightOf(positions, vertex, origin, normal));
  const count = first.length;
  const next = new Map<number, number>();
  for (let at = 0; at < indices.length; at += 3) {
    let [up, down] = [-1, -1];
    for (let corner = 0; corner < 3; corner++) {
      const a = first[indices[at + corner]!]!;
      const b = first[indices[at + ((corner + 1) % 3)]!]!;
      const [isAbove, goesAbove] = [heights[a]! >= 0, heights[b]! >= 0];
      if (isAbove === goesAbove) continue;
      // An edge is named from its end below the plane to the one above.
      if (goesAbove) up = a * count + b;
      else down = b * count + a;
    }
    // The neighbor across the edge that leads down passes it upwards, so that the line goes on there.
    if (up >= 0) next.set(up, down);
  }
  return closedLines(next).map((edges) => {
    const from = edges.map((edge) => Math.floor(edge / count));
    const to = edges.map((edge) => edge % count);
    const parts = from.map((a, i) => heights[a]! / (heights[a]! - heights[to[i]!]!));
    return { from, to, parts };
  });
}

/** Follows each edge to the next, and returns those that come back to where they began. */
function closedLines(next: Map<number, number>): number[][] {
  const lines: number[][] = [];
  const passed = new Set<number>();
  for (const start of next.keys()) {
    const line: number[] = [];
    let edge: number | undefined = start;
    while (edge !== undefined && !passed.has(edge)) {
      passed.add(edge);
      line.push(edge);
      edge = next.get(edge);
    }
    if (edge === start) lines.push(line);
  }
  return lines;
}

function heightOf(p: Float32Array, vertex: number, [x, y, z]: Triple, [a, b, c]: Triple): number {
  const at = vertex * 3;
  return (p[at]! - x) * a + (p[at + 1]! - y) * b + (p[at + 2]! - z) * c;
}

/**
 * The area inside an outline: half the length of the sum of the cross products of its corners, which
 * for a line that is not flat is the area of its projection along that sum.
 *
 * @param positions (vertexCount × 3) at rest or posed
 * @returns in square units of the positions
 */
export function outlineArea(outline: Outline, positions: Float32Array): number {
  return Math.hypot(...doubledArea(outline, positions)) / 2;
}

/** The sum of the cross products, about the first corner so that few digits cancel. */
function doubledArea(outline: Outline, positions: Float32Array): Triple {
  const [ox, oy, oz] = cornerOf(outline, 0, positions);
  let [x, y, z] = [0, 0, 0];
  let [px, py, pz] = [0, 0, 0];
  for (let i = 1; i < outline.from.length; i++) {
    const [cx, cy, cz] = cornerOf(outline, i, positions);
    const [qx, qy, qz] = [cx - ox, cy - oy, cz - oz];
    x += py * qz - pz * qy;
    y += pz * qx - px * qz;
    z += px * qy - py * qx;
    [px, py, pz] = [qx, qy, qz];
  }
  return [x, y, z];
}

function cornerOf({ from, to, parts }: Outline, i: number, p: Float32Array): Triple {
  const [a, b, part] = [from[i]! * 3, to[i]! * 3, parts[i]!];
  const along = (axis: number): number => p[a + axis]! + part * (p[b + axis]! - p[a + axis]!);
  return [along(0), along(1), along(2)];
}

/**
 * Returns the smallest of flat outlines that go around a point of their plane, or null if none does.
 *
 * @param positions (vertexCount × 3) those that were cut
 */
export function outlineAround(
  outlines: readonly Outline[],
  positions: Float32Array,
  origin: Triple,
  normal: Triple,
): Outline | null {
  const around = outlines.filter((outline) => turnsAround(outline, positions, origin, normal));
  const areas = around.map((outline) => outlineArea(outline, positions));
  return around[areas.indexOf(Math.min(...areas))] ?? null;
}

/** Whether a line goes around a point, by the sum of the angles under which it is seen from there. */
function turnsAround(
  outline: Outline,
  positions: Float32Array,
  [x, y, z]: Triple,
  [a, b, c]: Triple,
): boolean {
  const seen = outline.from.map((_, i): Triple => {
    const [px, py, pz] = cornerOf(outline, i, positions);
    return [px - x, py - y, pz - z];
  });
  const length = Math.hypot(a, b, c);
  const turn = seen.reduce((sum, [px, py, pz], i) => {
    const [qx, qy, qz] = seen[(i + 1) % seen.length]!;
    const sine = a * (py * qz - pz * qy) + b * (pz * qx - px * qz) + c * (px * qy - py * qx);
    return sum + Math.atan2(sine / length, px * qx + py * qy + pz * qz);
  }, 0);
  return Math.abs(turn) > Math.PI;
}
