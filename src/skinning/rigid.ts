import type { Mesh } from '../core/mesh.ts';
import type { InfluenceRows, Skin } from '../core/skin.ts';
import { transformNormalsByCofactors, transformPoints } from './affine-kernel.ts';
import { packAffinePalette } from './affine-palette.ts';
import { blockSize, createMatrixBlock } from './blend-matrices.ts';
import { heaviestEntry } from './heaviest-entry.ts';
import type { PosedStreams, SkinningMethod } from './method.ts';

/**
 * Every vertex follows only the joint with its largest weight (the first one if several are equal).
 * This is the handout's figure of colliding parts; it shows what blending is for.
 */
export const rigid: SkinningMethod<'rigid'> = {
  id: 'rigid',
  strides: [3],
  vec4sPerEntry: () => 3,
  packPalette: packAffinePalette,
  deform,
  wasm: { rows: heaviestInfluence, normals: 'cofactors' },
  chunk: 'rigid',
};

function deform(mesh: Mesh, skin: Skin, palette: Float32Array, out: PosedStreams): void {
  const { vertexCount, positions, normals } = mesh;
  for (let first = 0; first < vertexCount; first += blockSize) {
    const end = Math.min(first + blockSize, vertexCount);
    for (let vertex = first; vertex < end; vertex++) {
      const from = heaviestEntry(skin, mesh.pointOf[vertex]!) * 12;
      const to = (vertex - first) * 12;
      for (let i = 0; i < 12; i++) matrices[to + i] = palette[from + i]!;
    }
    transformPoints(matrices, positions, first, end, out.positions);
    if (out.normals) transformNormalsByCofactors(matrices, normals, first, end, out.normals);
  }
}

const matrices = createMatrixBlock();

/** One influence of weight 1 for each point: 0 + 1 · M has the bits of M. */
function heaviestInfluence(skin: Skin): InfluenceRows {
  const start = Uint32Array.from(skin.start.keys());
  const entries = Uint16Array.from(start.subarray(1), (_, point) => heaviestEntry(skin, point));
  return { start, entries, weights: new Float32Array(entries.length).fill(1) };
}
