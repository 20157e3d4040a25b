import type { Mesh } from '../../src/core/mesh.ts';
import type { Skin } from '../../src/core/skin.ts';
import type { MethodSettings, SkinningMethod } from '../../src/skinning/method.ts';
import { useOf } from './method-use.ts';
import type { WasmSkinning } from '../../src/skinning/wasm/wasm-skinning.ts';

/**
 * Counts the posed numbers whose bits differ between the strict kernel and the WebAssembly kernel:
 * positions and normals together, and positions alone.
 */
export function bitDifferences(
  wasm: WasmSkinning,
  method: SkinningMethod,
  mesh: Mesh,
  skin: Skin,
  palette: Float32Array,
  settings?: MethodSettings,
): number {
  const room = (): Float32Array => new Float32Array(mesh.vertexCount * 3).fill(NaN);
  const strict = { positions: room(), normals: room() };
  const both = { positions: room(), normals: room() };
  const alone = { positions: room(), normals: null };
  const use = useOf(method, mesh, skin, settings);
  method.deform(mesh, skin, palette, strict, use);
  for (const out of [both, alone]) {
    if (!wasm.deform(method, mesh, skin, palette, out, use))
      throw new Error(`${method.id} has no plan`);
  }
  return (
    differing(both.positions, strict.positions) +
    differing(both.normals, strict.normals) +
    differing(alone.positions, strict.positions)
  );
}

function differing(a: Float32Array, b: Float32Array): number {
  const [left, right] = [new Uint32Array(a.buffer), new Uint32Array(b.buffer)];
  return left.reduce((count, bits, i) => count + (bits === right[i] ? 0 : 1), 0);
}
