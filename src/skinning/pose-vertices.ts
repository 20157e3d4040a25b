import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import type { MethodUse, PosedStreams, SkinningMethod } from './method.ts';
import type { WasmSkinning } from './wasm/wasm-skinning.ts';

/**
 * Computes the posed vertices of a method on the CPU, from start to end.
 *
 * @param mesh before its rest layers
 * @param rest the mesh after them
 * @param wasm computes the same bits in less time, where it has the method
 */
export function poseVertices(
  method: SkinningMethod,
  mesh: Mesh,
  rest: Mesh,
  skin: Skin,
  palette: Float32Array,
  use: MethodUse,
  out: PosedStreams,
  wasm: WasmSkinning | null = null,
): void {
  const skinned = method.finish ? mesh : rest;
  if (!wasm?.deform(method, skinned, skin, palette, out, use)) {
    method.deform(skinned, skin, palette, out, use);
  }
  method.finish?.(mesh, rest, skin, out, use);
}
