import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { transformNormalsByCofactors, transformPoints } from './affine-kernel.ts';
import { packAffinePalette } from './affine-palette.ts';
import { blendMatrices, blockSize, createMatrixBlock } from './blend-matrices.ts';
import { everyInfluence, type PosedStreams, type SkinningMethod } from './method.ts';

/**
 * Skeletal subspace deformation: `p' = Σ wᵢ Tᵢ Bᵢ⁻¹ p` over all influences of the file, with
 * unchanged weights. The matrices are blended first, from left to right, and the result is applied
 * once.
 */
export const linearBlend: SkinningMethod<'linear-blend'> = {
  id: 'linear-blend',
  strides: [3],
  vec4sPerEntry: () => 3,
  packPalette: packAffinePalette,
  deform,
  wasm: { rows: everyInfluence, normals: 'cofactors' },
  chunk: 'linear-blend',
};

function deform(mesh: Mesh, skin: Skin, palette: Float32Array, out: PosedStreams): void {
  const { vertexCount, positions, normals } = mesh;
  for (let first = 0; first < vertexCount; first += blockSize) {
    const end = Math.min(first + blockSize, vertexCount);
    blendMatrices(mesh, skin, palette, 12, 0, first, end, matrices);
    transformPoints(matrices, positions, first, end, out.positions);
    if (out.normals) transformNormalsByCofactors(matrices, normals, first, end, out.normals);
  }
}

const matrices = createMatrixBlock();
