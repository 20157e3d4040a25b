import { linearBlend } from '../../skinning/linear-blend.ts';
import { poseVertices } from '../../skinning/pose-vertices.ts';
import type { Deformation } from '../../skinning/registry.ts';
import type { Evaluation } from '../evaluation.ts';
import type { Kernels } from '../kernels.ts';

/**
 * Computes where another method puts the vertices of a character that is posed as an evaluation has
 * it, on the CPU. Linear blend stands in for a method that is not ready.
 *
 * @param positions (vertexCount × 3) written and returned; character space
 */
export function verticesBy(
  { state, rest, skin, characterFromJoint }: Evaluation,
  deformation: Partial<Deformation>,
  kernels: Kernels,
  positions = new Float32Array(rest.vertexCount * 3),
): Float32Array {
  const actor = { ...state, ...deformation };
  const method = kernels.readyFor(actor) ?? linearBlend;
  const palette = new Float32Array(skin.paletteJoint.length * method.vec4sPerEntry(skin) * 4);
  method.packPalette(skin, characterFromJoint, palette);
  const use = { extra: kernels.extraOf(method, actor), settings: actor.methodSettings };
  const out = { positions, normals: null };
  poseVertices(method, state.character.mesh, rest, skin, palette, use, out, kernels.wasm);
  return positions;
}
