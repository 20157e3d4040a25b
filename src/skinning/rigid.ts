import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { transformVertex } from './affine-kernel.ts';
import { packAffinePalette } from './affine-palette.ts';
import type { SkinningMethod, VertexStreams } from './method.ts';

/**
 * Every vertex follows only the joint with its largest weight (the first one if several are equal).
 * This is the handout's figure of colliding parts; it shows what blending is for.
 */
export const rigid: SkinningMethod<'rigid'> = {
  id: 'rigid',
  vec4sPerEntry: 3,
  packPalette: packAffinePalette,
  deform,
  chunk: 'rigid',
};

function deform(mesh: Mesh, skin: Skin, palette: Float32Array, out: VertexStreams): void {
  for (let vertex = 0; vertex < mesh.vertexCount; vertex++) {
    const entry = heaviestEntry(skin, mesh.pointOf[vertex]!);
    for (let i = 0; i < 12; i++) rows[i] = palette[entry * 12 + i]!;
    transformVertex(rows, mesh, vertex, out);
  }
}

const rows = new Float32Array(12);

function heaviestEntry(skin: Skin, point: number): number {
  let entry = 0;
  let heaviest = 0;
  for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
    if (skin.weights[i]! <= heaviest) continue;
    heaviest = skin.weights[i]!;
    entry = skin.entries[i]!;
  }
  return entry;
}
