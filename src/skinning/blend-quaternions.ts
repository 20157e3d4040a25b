import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { blockSize } from './blend-matrices.ts';
import { heaviestEntry } from './heaviest-entry.ts';

const { fround } = Math;

/** Makes room for the quaternions of a block, 4 numbers each. */
export function createQuaternionBlock(): Float32Array {
  return new Float32Array(blockSize * 4);
}

/**
 * Blends four numbers for every vertex of a range: `Σ sᵢ wᵢ qᵢ`, from left to right, in float32.
 * The sign s turns a rotation that points away from the pivot, which is that of the largest weight
 * (the first one if several are equal), since a quaternion and its opposite are the same rotation.
 * Negative weights count as 0, and the sum is not normalized. This mirrors
 * shaders/lib/quaternions.glsl, operation by operation.
 *
 * @param palette has `stride` numbers per entry, with its rotation (xyzw) from `rotation` on and
 *   the four that are blended from `offset` on
 * @param blended (4 numbers a vertex) written from its beginning; the range is at most a block
 */
export function blendQuaternions(
  { pointOf }: Mesh,
  skin: Skin,
  palette: Float32Array,
  stride: number,
  rotation: number,
  offset: number,
  first: number,
  end: number,
  blended: Float32Array,
): void {
  const { start, entries, weights } = skin;
  for (let vertex = first, to = 0; vertex < end; vertex++, to += 4) {
    const point = pointOf[vertex]!;
    const last = start[point + 1]!;
    const pivot = heaviestEntry(skin, point) * stride + rotation;
    const px = palette[pivot]!;
    const py = palette[pivot + 1]!;
    const pz = palette[pivot + 2]!;
    const pw = palette[pivot + 3]!;
    let x = 0;
    let y = 0;
    let z = 0;
    let w = 0;
    for (let i = start[point]!; i < last; i++) {
      const turn = entries[i]! * stride + rotation;
      const from = entries[i]! * stride + offset;
      const qx = palette[turn]!;
      const qy = palette[turn + 1]!;
      const qz = palette[turn + 2]!;
      const qw = palette[turn + 3]!;
      const weight = weights[i]! > 0 ? weights[i]! : 0;
      const signed = dotFour(px, py, pz, pw, qx, qy, qz, qw) < 0 ? -weight : weight;
      x = fround(x + fround(signed * palette[from]!));
      y = fround(y + fround(signed * palette[from + 1]!));
      z = fround(z + fround(signed * palette[from + 2]!));
      w = fround(w + fround(signed * palette[from + 3]!));
    }
    blended[to] = x;
    blended[to + 1] = y;
    blended[to + 2] = z;
    blended[to + 3] = w;
  }
}

/**
 * Scales a blended quaternion of length 1 to the upper 3 × 3 of its rotation's matrix, and writes
 * it into the first three numbers of the rows.
 *
 * @param scale 1 / its length
 * @param rows (12) 3 × 4 row by row from `to` on
 */
export function writeRotationRows(
  blended: Float32Array,
  at: number,
  scale: number,
  rows: Float32Array,
  to: number,
): void {
  const x = fround(blended[at]! * scale);
  const y = fround(blended[at + 1]! * scale);
  const z = fround(blended[at + 2]! * scale);
  const w = fround(blended[at + 3]! * scale);
  // Twice a number is exact, so these are rounded once.
  const xx = fround(x * (2 * x));
  const yy = fround(y * (2 * y));
  const zz = fround(z * (2 * z));
  const xy = fround(x * (2 * y));
  const xz = fround(x * (2 * z));
  const yz = fround(y * (2 * z));
  const wx = fround(w * (2 * x));
  const wy = fround(w * (2 * y));
  const wz = fround(w * (2 * z));
  rows[to] = fround(1 - fround(yy + zz));
  rows[to + 1] = fround(xy - wz);
  rows[to + 2] = fround(xz + wy);
  rows[to + 4] = fround(xy + wz);
  rows[to + 5] = fround(1 - fround(xx + zz));
  rows[to + 6] = fround(yz - wx);
  rows[to + 8] = fround(xz - wy);
  rows[to + 9] = fround(yz + wx);
  rows[to + 10] = fround(1 - fround(xx + yy));
}

/** Below this squared length a blended quaternion has no direction left: 1e-6 squared. */
export const smallestSquare = fround(1e-12);

export function dotFour(
  ax: number,
  ay: number,
  az: number,
  aw: number,
  bx: number,
  by: number,
  bz: number,
  bw: number,
): number {
  const three = fround(fround(fround(ax * bx) + fround(ay * by)) + fround(az * bz));
  return fround(three + fround(aw * bw));
}
