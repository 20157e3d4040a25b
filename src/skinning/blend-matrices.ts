import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';

/**
 * Kernels work through a mesh in blocks of this many vertices. A block's matrices stay in the
 * processor's nearest cache between the loops that make and apply them.
 */
export const blockSize = 64;

/** Makes room for the 3 × 4 matrices of a block, 12 numbers each, row by row. */
export function createMatrixBlock(): Float32Array {
  return new Float32Array(blockSize * 12);
}

/**
 * Blends one 3 × 4 matrix for every vertex of a range: `Σ wᵢ Mᵢ`, from left to right, in float32.
 *
 * @param palette has `stride` numbers per entry, of which the 12 from `offset` on are blended
 * @param matrices written from its beginning; the range is at most a block
 */
export function blendMatrices(
  { pointOf }: Mesh,
  { start, entries, weights }: Skin,
  palette: Float32Array,
  stride: number,
  offset: number,
  first: number,
  end: number,
  matrices: Float32Array,
): void {
  const { fround } = Math;
  for (let vertex = first, to = 0; vertex < end; vertex++, to += 12) {
    const point = pointOf[vertex]!;
    const last = start[point + 1]!;
    // The sums are single variables, because these stay in registers, unlike elements of an array.
    let m00 = 0;
    let m01 = 0;
    let m02 = 0;
    let m03 = 0;
    let m10 = 0;
    let m11 = 0;
    let m12 = 0;
    let m13 = 0;
    let m20 = 0;
    let m21 = 0;
    let m22 = 0;
    let m23 = 0;
    for (let i = start[point]!; i < last; i++) {
      const weight = weights[i]!;
      const from = entries[i]! * stride + offset;
      m00 = fround(m00 + fround(weight * palette[from]!));
      m01 = fround(m01 + fround(weight * palette[from + 1]!));
      m02 = fround(m02 + fround(weight * palette[from + 2]!));
      m03 = fround(m03 + fround(weight * palette[from + 3]!));
      m10 = fround(m10 + fround(weight * palette[from + 4]!));
      m11 = fround(m11 + fround(weight * palette[from + 5]!));
      m12 = fround(m12 + fround(weight * palette[from + 6]!));
      m13 = fround(m13 + fround(weight * palette[from + 7]!));
      m20 = fround(m20 + fround(weight * palette[from + 8]!));
      m21 = fround(m21 + fround(weight * palette[from + 9]!));
      m22 = fround(m22 + fround(weight * palette[from + 10]!));
      m23 = fround(m23 + fround(weight * palette[from + 11]!));
    }
    matrices[to] = m00;
    matrices[to + 1] = m01;
    matrices[to + 2] = m02;
    matrices[to + 3] = m03;
    matrices[to + 4] = m10;
    matrices[to + 5] = m11;
    matrices[to + 6] = m12;
    matrices[to + 7] = m13;
    matrices[to + 8] = m20;
    matrices[to + 9] = m21;
    matrices[to + 10] = m22;
    matrices[to + 11] = m23;
  }
}
