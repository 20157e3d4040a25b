import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { transformVertex } from './affine-kernel.ts';
import { packAffinePalette } from './affine-palette.ts';
import type { SkinningMethod, VertexStreams } from './method.ts';

const { fround } = Math;

/**
 * Skeletal subspace deformation: `p' = Σ wᵢ Tᵢ Bᵢ⁻¹ p` over all influences of the file, with
 * unchanged weights. The matrices are blended first, from left to right, and the result is applied
 * once.
 */
export const linearBlend: SkinningMethod<'linear-blend'> = {
  id: 'linear-blend',
  vec4sPerEntry: 3,
  packPalette: packAffinePalette,
  deform,
  chunk: 'linear-blend',
};

function deform(mesh: Mesh, skin: Skin, palette: Float32Array, out: VertexStreams): void {
  for (let vertex = 0; vertex < mesh.vertexCount; vertex++) {
    const point = mesh.pointOf[vertex]!;
    blended.fill(0);
    for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
      accumulate(palette, skin.entries[i]!, skin.weights[i]!);
    }
    transformVertex(blended, mesh, vertex, out);
  }
}

/** (3 × 4) the blended matrix, in rows; storing rounds each sum to float32. */
const blended = new Float32Array(12);

function accumulate(palette: Float32Array, entry: number, weight: number): void {
  for (let i = 0; i < 12; i++) {
    blended[i] = blended[i]! + fround(weight * palette[entry * 12 + i]!);
  }
}
