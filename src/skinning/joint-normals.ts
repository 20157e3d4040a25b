import { flushSubnormal } from '../core/float32.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { writeAffineRows } from './affine-palette.ts';
import { dot, makeUnit, transformPoints } from './affine-kernel.ts';
import { blendMatrices, blockSize, createMatrixBlock } from './blend-matrices.ts';
import { everyInfluence, type PosedStreams, type SkinningMethod } from './method.ts';

const { fround } = Math;

/**
 * Linear blend as CSE169 (project 2) defines it: positions `v' = Σ w W B⁻¹ v`, and normals `n' = Σ
 * w (W B⁻¹)⁻ᵀ n`, where each joint transforms the normal on its own. Where joints bend, this
 * differs from `linearBlend`, which transforms normals by the blended matrix and follows the
 * surface more closely.
 */
export const jointNormals: SkinningMethod<'joint-normals'> = {
  id: 'joint-normals',
  strides: [6],
  vec4sPerEntry: () => 6,
  packPalette,
  deform,
  wasm: { rows: everyInfluence, normals: 'next-rows' },
  chunk: 'joint-normals',
};

const floatsPerEntry = 24;

/** Three rows of W B⁻¹, then three of its inverse transpose (their fourth number is 0). */
function packPalette(skin: Skin, characterFromJoint: Float64Array, palette: Float32Array): void {
  for (let entry = 0; entry < skin.paletteJoint.length; entry++) {
    const at = entry * floatsPerEntry;
    writeAffineRows(skin, characterFromJoint, entry, affine, 0);
    for (let i = 0; i < 12; i++) palette[at + i] = flushSubnormal(affine[i]!);
    writeInverseTranspose(palette, at + 12);
  }
}

/** (3 × 4) W B⁻¹ of one entry, float64. */
const affine = new Float64Array(12);

/**
 * Writes the cofactors of `affine` divided by its determinant, in rows of four; zeros if it has no
 * inverse.
 */
function writeInverseTranspose(out: Float32Array, at: number): void {
  let determinant = 0;
  for (let column = 0; column < 3; column++) determinant += affine[column]! * cofactor(0, column);
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 3; column++) {
      const value = determinant === 0 ? 0 : cofactor(row, column) / determinant;
      out[at + row * 4 + column] = flushSubnormal(fround(value));
    }
    out[at + row * 4 + 3] = 0;
  }
}

function cofactor(row: number, column: number): number {
  const r1 = ((row + 1) % 3) * 4;
  const r2 = ((row + 2) % 3) * 4;
  const c1 = (column + 1) % 3;
  const c2 = (column + 2) % 3;
  return affine[r1 + c1]! * affine[r2 + c2]! - affine[r1 + c2]! * affine[r2 + c1]!;
}

function deform(mesh: Mesh, skin: Skin, palette: Float32Array, out: PosedStreams): void {
  const { vertexCount, positions, normals } = mesh;
  for (let first = 0; first < vertexCount; first += blockSize) {
    const end = Math.min(first + blockSize, vertexCount);
    blendMatrices(mesh, skin, palette, floatsPerEntry, 0, first, end, matrices);
    transformPoints(matrices, positions, first, end, out.positions);
    if (!out.normals) continue;
    blendMatrices(mesh, skin, palette, floatsPerEntry, 12, first, end, matrices);
    transformNormals(matrices, normals, first, end, out.normals);
  }
}

const matrices = createMatrixBlock();

/**
 * Transforms normals by the upper 3 × 3 of their matrices, and normalizes them. The fourth number
 * of a row is not read.
 */
function transformNormals(
  matrices: Float32Array,
  normals: Float32Array,
  first: number,
  end: number,
  out: Float32Array,
): void {
  for (let at = first * 3, m = 0; at < end * 3; at += 3, m += 12) {
    const nx = normals[at]!;
    const ny = normals[at + 1]!;
    const nz = normals[at + 2]!;
    out[at] = dot(matrices[m]!, matrices[m + 1]!, matrices[m + 2]!, nx, ny, nz);
    out[at + 1] = dot(matrices[m + 4]!, matrices[m + 5]!, matrices[m + 6]!, nx, ny, nz);
    out[at + 2] = dot(matrices[m + 8]!, matrices[m + 9]!, matrices[m + 10]!, nx, ny, nz);
  }
  makeUnit(out, first, end);
}
