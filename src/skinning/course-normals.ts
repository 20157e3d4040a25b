import type { Skin } from '../core/skin.ts';
import type { Mesh } from '../core/mesh.ts';
import { noJoint } from '../core/skin.ts';
import { flushSubnormal } from '../core/float32.ts';

/**
 * Normals as CSE169 (project 2) asks: `n' = Σ w (W B⁻¹)⁻ᵀ n`, made unit, each joint turning the normal
 * on its own. Where joints bend this is not what linear blend does, which turns by the blended matrix
 * and follows the blended surface more closely; for rigid joints it is the sum of rotated normals.
 * Float64, rounded once.
 *
 * @param worldFromJoint (jointCount × 16)
 * @param normals (vertexCount × 3) written, unit
 */
export function courseNormals(
  mesh: Mesh,
  skin: Skin,
  worldFromJoint: Float64Array,
  normals: Float32Array,
): void {
  const turns = inverseTransposes(skin, worldFromJoint);
  for (let vertex = 0; vertex < mesh.vertexCount; vertex++) {
    const point = mesh.pointOf[vertex]!;
    const sum = [0, 0, 0];
    for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
      const at = skin.entries[i]! * 9;
      for (let row = 0; row < 3; row++) {
        for (let column = 0; column < 3; column++) {
          const turned = turns[at + row * 3 + column]! * mesh.normals[vertex * 3 + column]!;
          sum[row] = sum[row]! + skin.weights[i]! * turned;
        }
      }
    }
    const length = Math.hypot(...sum);
    for (let i = 0; i < 3; i++) {
      normals[vertex * 3 + i] =
        length > 1e-15 ? flushSubnormal(sum[i]! / length) : mesh.normals[vertex * 3 + i]!;
    }
  }
}

/** (entryCount × 9) rows of the inverse transpose of each entry's upper 3 × 3. */
function inverseTransposes(skin: Skin, worldFromJoint: Float64Array): Float64Array {
  const out = new Float64Array(skin.paletteJoint.length * 9);
  const matrix = new Float64Array(9);
  skin.paletteJoint.forEach((joint, entry) => {
    for (let row = 0; row < 3; row++) {
      for (let column = 0; column < 3; column++) {
        let sum = 0;
        for (let k = 0; k < 3; k++) {
          const world =
            joint === noJoint ? Number(k === row) : worldFromJoint[joint * 16 + k * 4 + row]!;
          sum += world * skin.jointFromBind[entry * 16 + column * 4 + k]!;
        }
        matrix[row * 3 + column] = sum;
      }
    }
    writeInverseTranspose(matrix, out.subarray(entry * 9, entry * 9 + 9));
  });
  return out;
}

/** Cofactors over the determinant; all zero where there is no inverse. */
function writeInverseTranspose(m: Float64Array, out: Float64Array): void {
  for (let row = 0; row < 3; row++) {
    const [r1, r2] = [((row + 1) % 3) * 3, ((row + 2) % 3) * 3];
    for (let column = 0; column < 3; column++) {
      const [c1, c2] = [(column + 1) % 3, (column + 2) % 3];
      out[row * 3 + column] = m[r1 + c1]! * m[r2 + c2]! - m[r1 + c2]! * m[r2 + c1]!;
    }
  }
  const determinant = m[0]! * out[0]! + m[1]! * out[1]! + m[2]! * out[2]!;
  for (let i = 0; i < 9; i++) out[i] = determinant === 0 ? 0 : out[i]! / determinant;
}
