import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { dot } from './affine-kernel.ts';
import { blendMatrices } from './blend-matrices.ts';
import {
  blendQuaternions,
  createQuaternionBlock,
  dotFour,
  smallestSquare,
  writeRotationRows,
} from './blend-quaternions.ts';

const { fround, sqrt } = Math;

// This mirrors shaders/skinning/dual-quaternion.glsl, operation by operation: change one with the
// other. Within an entry of the palette there are these offsets, in numbers.
export const rotationAt = 12;
const dualAt = 16;
const stretchAt = 20;

/**
 * Blends the dual quaternions of every vertex of a range, and writes the motions as 3 × 4 matrices.
 * Vertices whose blend has no direction get their matrix of linear blend.
 *
 * @param palette has `stride` numbers per entry: a matrix, a dual quaternion, and perhaps a stretch
 * @param matrices (12 numbers a vertex, row by row) written; the range is at most a block
 */
export function blendMotions(
  mesh: Mesh,
  skin: Skin,
  palette: Float32Array,
  stride: number,
  first: number,
  end: number,
  matrices: Float32Array,
): void {
  blendQuaternions(mesh, skin, palette, stride, rotationAt, rotationAt, first, end, rotations);
  blendQuaternions(mesh, skin, palette, stride, rotationAt, dualAt, first, end, duals);
  for (let vertex = first, at = 0, to = 0; vertex < end; vertex++, at += 4, to += 12) {
    const x = rotations[at]!;
    const y = rotations[at + 1]!;
    const z = rotations[at + 2]!;
    const w = rotations[at + 3]!;
    const squared = dotFour(x, y, z, w, x, y, z, w);
    if (squared >= smallestSquare) {
      const scale = fround(1 / fround(sqrt(squared)));
      writeRotationRows(rotations, at, scale, matrices, to);
      writeTranslation(at, scale, matrices, to);
      if (stride <= stretchAt) continue;
      stretchRows(skin, palette, stride, mesh.pointOf[vertex]!, matrices, to);
    } else {
      blendMatrices(mesh, skin, palette, stride, 0, vertex, vertex + 1, single);
      for (let i = 0; i < 12; i++) matrices[to + i] = single[i]!;
    }
  }
}

const rotations = createQuaternionBlock();
const duals = createQuaternionBlock();
const single = new Float32Array(12);

/** The vector part of 2 ce conj(c0), where c0 and ce are the parts of length 1. */
function writeTranslation(at: number, scale: number, rows: Float32Array, to: number): void {
  const x = fround(rotations[at]! * scale);
  const y = fround(rotations[at + 1]! * scale);
  const z = fround(rotations[at + 2]! * scale);
  const w = fround(rotations[at + 3]! * scale);
  const ex = fround(duals[at]! * scale);
  const ey = fround(duals[at + 1]! * scale);
  const ez = fround(duals[at + 2]! * scale);
  const ew = fround(duals[at + 3]! * scale);
  rows[to + 3] = 2 * translation(w, ex, ew, x, y, ez, z, ey);
  rows[to + 7] = 2 * translation(w, ey, ew, y, z, ex, x, ez);
  rows[to + 11] = 2 * translation(w, ez, ew, z, x, ey, y, ex);
}

/** (a b − c d) + (e f − g h) */
function translation(
  a: number,
  b: number,
  c: number,
  d: number,
  e: number,
  f: number,
  g: number,
  h: number,
): number {
  const own = fround(fround(a * b) - fround(c * d));
  return fround(own + fround(fround(e * f) - fround(g * h)));
}

/** Multiplies a matrix from the right by the mean stretch of a point. */
function stretchRows(
  { start, entries, weights }: Skin,
  palette: Float32Array,
  stride: number,
  point: number,
  rows: Float32Array,
  to: number,
): void {
  stretch.fill(0);
  for (let i = start[point]!; i < start[point + 1]!; i++) {
    const weight = weights[i]! > 0 ? weights[i]! : 0;
    const from = entries[i]! * stride + stretchAt;
    for (let k = 0; k < 12; k++) {
      stretch[k] = fround(stretch[k]! + fround(weight * palette[from + k]!));
    }
  }
  // The fourth number of the first row is the sum of the weights.
  const scale = fround(1 / stretch[3]!);
  for (let row = to; row < to + 12; row += 4) {
    const [x, y, z] = [rows[row]!, rows[row + 1]!, rows[row + 2]!];
    for (let column = 0; column < 3; column++) {
      const [a, b, c] = [stretch[column]!, stretch[4 + column]!, stretch[8 + column]!];
      rows[row + column] = fround(dot(x, y, z, a, b, c) * scale);
    }
  }
}

const stretch = new Float32Array(12);
