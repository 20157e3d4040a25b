import { flushSubnormal } from '../../core/float32.ts';
import type { Mesh } from '../../core/mesh.ts';
import type { Skin } from '../../core/skin.ts';
import { meanRow, type PositiveRow, positiveRows } from './positive-rows.ts';
import { SharedSurface, type Sums } from './shared-surface.ts';

/** The x of a point that has no center; no model is as large. */
const noCenter = Math.fround(3e38);

/** @param at where the center is in the result of `restCenters` */
export function hasCenter(centers: Float32Array, at: number): boolean {
  return centers[at]! < 1e38;
}

/** Up to this many triangles that share two joints are summed one by one. */
const exactLimit = 2048;

/** Progress is reported each time this many points are done. */
const pointsPerReport = 256;

/** The pairs of joints that move something together, by both palette entries. */
type SurfaceOfPair = Map<number, SharedSurface>;

/**
 * Computes the center of rotation of every point in the bind pose (Le and Hodgins 2016, equations 1
 * and 4): the mean of the whole surface, in which each triangle counts by its area and by how alike
 * its weights and those of the point are,
 *
 *     p* = ∫ s(w, v) x dA / ∫ s(w, v) dA,
 *     s(w, v) = Σ over j ≠ k of wⱼ wₖ vⱼ vₖ exp(−(wⱼ vₖ − wₖ vⱼ)² / σ²),  σ = 0.1.
 *
 * A triangle has the mean weights of its corners. The sum is taken pair by pair of joints, so that
 * each point meets only triangles with which it shares two joints.
 *
 * @param onProgress gets the part that is done, from 0 to 1
 * @param limit up to this many triangles of a pair the sum is exact; more are clustered
 * @returns (pointCount × 3) in the character's space; see `hasCenter` for points without one,
 *   which follow only one joint
 */
export function restCenters(
  mesh: Mesh,
  skin: Skin,
  onProgress: (part: number) => void,
  limit = exactLimit,
): Float32Array {
  const rows = positiveRows(skin);
  const surfaces = surfacesOf(mesh, rows, skin.paletteJoint.length, limit);
  const centers = new Float32Array(rows.length * 3);
  rows.forEach((row, point) => {
    const sums: Sums = [0, 0, 0, 0];
    eachPair(row, skin.paletteJoint.length, (pair, first, second) =>
      surfaces.get(pair)?.addTo(sums, first, second),
    );
    const [mass, ...moment] = sums;
    if (mass > 0) {
      moment.forEach((value, axis) => {
        centers[point * 3 + axis] = flushSubnormal(value / mass);
      });
    } else centers[point * 3] = noCenter;
    if (point % pointsPerReport === 0) onProgress(point / rows.length);
  });
  return centers;
}

function surfacesOf(
  { indices, pointOf, positions }: Mesh,
  rows: readonly PositiveRow[],
  entryCount: number,
  limit: number,
): SurfaceOfPair {
  const surfaces: SurfaceOfPair = new Map();
  for (let at = 0; at < indices.length; at += 3) {
    const corners = [...indices.subarray(at, at + 3)];
    const [a, b, c] = corners.map((vertex) => positions.subarray(vertex * 3, vertex * 3 + 3));
    const area = areaOf(a!, b!, c!);
    if (area === 0) continue;
    const centroid = [0, 1, 2].map((axis) => (a![axis]! + b![axis]! + c![axis]!) / 3);
    const [rowA, rowB, rowC] = corners.map((vertex) => rows[pointOf[vertex]!]!);
    eachPair(meanRow(rowA!, rowB!, rowC!), entryCount, (pair, first, second) => {
      let surface = surfaces.get(pair);
      if (!surface) surfaces.set(pair, (surface = new SharedSurface(limit)));
      surface.add(first, second, area, centroid);
    });
  }
  return surfaces;
}

/** Visits every pair of joints of a row, under a number of its own, with both weights. */
function eachPair(
  { entries, weights }: PositiveRow,
  entryCount: number,
  visit: (pair: number, first: number, second: number) => void,
): void {
  for (let i = 0; i < entries.length; i++) {
    for (let k = i + 1; k < entries.length; k++) {
      visit(entries[i]! * entryCount + entries[k]!, weights[i]!, weights[k]!);
    }
  }
}

function areaOf(a: ArrayLike<number>, b: ArrayLike<number>, c: ArrayLike<number>): number {
  const [ux, uy, uz] = [b[0]! - a[0]!, b[1]! - a[1]!, b[2]! - a[2]!];
  const [vx, vy, vz] = [c[0]! - a[0]!, c[1]! - a[1]!, c[2]! - a[2]!];
  return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
}
