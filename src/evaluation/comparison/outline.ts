import type { Mesh } from '../../core/mesh.ts';
import { weldedCorners } from './closed-components.ts';
import { type CutLine, cutLines } from './cut-lines.ts';

type Triple = readonly [number, number, number];
type Surface = Pick<Mesh, 'positions' | 'indices'>;

/** A closed line around a surface, which moves with it. */
export type Outline = Omit<CutLine, 'isClosed'>;

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
  const corners = weldedCorners(positions, indices);
  return cutLines(positions, corners, origin, normal).filter(({ isClosed }) => isClosed);
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

/** The place of a corner of a line on a surface that has these positions. */
export function cornerOf({ from, to, parts }: Outline, i: number, p: Float32Array): Triple {
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
