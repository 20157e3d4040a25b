import { flushSubnormal } from '../core/float32.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { packAffinePalette } from './affine-palette.ts';
import { transformNormalBy, transformPoint } from './affine-kernel.ts';
import type { SkinningMethod, VertexStreams } from './method.ts';

const { fround } = Math;

/**
 * Linear blend as CSE169 (project 2) asks for it: positions `v' = Σ w W B⁻¹ v`, and normals likewise,
 * `n' = Σ w (W B⁻¹)⁻ᵀ n`, each joint turning the normal on its own. Where joints bend this is not
 * what `linearBlend` does, which turns by the blended matrix and follows the surface more closely.
 */
export const jointNormals: SkinningMethod<'joint-normals'> = {
  id: 'joint-normals',
  vec4sPerEntry: 6,
  packPalette,
  deform,
  chunk: 'joint-normals',
};

const floatsPerEntry = 24;

/** Three rows of W B⁻¹, then three of its inverse transpose (their fourth number is 0). */
function packPalette(skin: Skin, characterFromJoint: Float64Array, palette: Float32Array): void {
  const entryCount = skin.paletteJoint.length;
  const affine = new Float64Array(entryCount * 12);
  packAffinePalette(skin, characterFromJoint, affine);
  for (let entry = 0; entry < entryCount; entry++) {
    const matrix = affine.subarray(entry * 12, entry * 12 + 12);
    const at = entry * floatsPerEntry;
    for (let i = 0; i < 12; i++) palette[at + i] = flushSubnormal(matrix[i]!);
    writeInverseTranspose(matrix, palette, at + 12);
  }
}

/** Cofactors over the determinant, by rows of four; all zero where there is no inverse. */
function writeInverseTranspose(rows: Float64Array, out: Float32Array, at: number): void {
  const cofactor = (row: number, column: number): number => {
    const [r1, r2] = [((row + 1) % 3) * 4, ((row + 2) % 3) * 4];
    const [c1, c2] = [(column + 1) % 3, (column + 2) % 3];
    return rows[r1 + c1]! * rows[r2 + c2]! - rows[r1 + c2]! * rows[r2 + c1]!;
  };
  let determinant = 0;
  for (let column = 0; column < 3; column++) determinant += rows[column]! * cofactor(0, column);
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 3; column++) {
      const value = determinant === 0 ? 0 : cofactor(row, column) / determinant;
      out[at + row * 4 + column] = flushSubnormal(fround(value));
    }
    out[at + row * 4 + 3] = 0;
  }
}

function deform(mesh: Mesh, skin: Skin, palette: Float32Array, out: VertexStreams): void {
  for (let vertex = 0; vertex < mesh.vertexCount; vertex++) {
    const point = mesh.pointOf[vertex]!;
    blended.fill(0);
    for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
      accumulate(palette, skin.entries[i]!, skin.weights[i]!);
    }
    transformPoint(blended, mesh, vertex, out);
    transformNormalBy(blended, 12, mesh, vertex, out);
  }
}

/** (6 × 4) the blended rows; storing rounds each sum to float32. */
const blended = new Float32Array(floatsPerEntry);

function accumulate(palette: Float32Array, entry: number, weight: number): void {
  for (let i = 0; i < floatsPerEntry; i++) {
    blended[i] = blended[i]! + fround(weight * palette[entry * floatsPerEntry + i]!);
  }
}
