import type { Character } from '../../src/core/character.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { linearBlend } from '../../src/skinning/linear-blend.ts';
import { WasmSkinning } from '../../src/skinning/wasm/wasm-skinning.ts';
import { compileKernel } from '../../tools/compile-kernel.ts';
import { characterOf } from '../data/character.ts';
import type { Cylinder } from '../data/cylinder.ts';
import { plainUse, type SkinningMethod } from '../../src/skinning/method.ts';

/** A program that poses the vertices of a body again and again. */
export interface Skinning {
  readonly positions: ArrayLike<number>;
  readonly normals?: ArrayLike<number>;
  readonly run: () => void;
}

/** A body as the product has it, in a pose. */
export interface PosedBody {
  readonly method: SkinningMethod;
  readonly character: Character;
  /** (jointCount × 16) column-major. */
  readonly characterFromJoint: Float64Array;
  readonly palette: Float32Array;
}

export function posedBody(
  body: Cylinder,
  angles: Float64Array,
  method: SkinningMethod = linearBlend,
): PosedBody {
  const character = characterOf(body);
  const { skin, skeleton } = character;
  const characterFromJoint = jointMatrices(skeleton, angles);
  const palette = new Float32Array(skin.paletteJoint.length * method.vec4sPerEntry(skin) * 4);
  method.packPalette(skin, characterFromJoint, palette);
  return { method, character, characterFromJoint, palette };
}

/** The definition of the method, in TypeScript. */
export function strictSkinning({
  method,
  character: { mesh, skin },
  palette,
}: PosedBody): Skinning {
  const out = {
    positions: new Float32Array(mesh.vertexCount * 3),
    normals: new Float32Array(mesh.vertexCount * 3),
  };
  return { ...out, run: () => method.deform(mesh, skin, palette, out, plainUse) };
}

/** The WebAssembly kernel, with normals or without. */
export async function wasmSkinning(
  { method, character: { mesh, skin }, palette }: PosedBody,
  withNormals: boolean,
): Promise<Skinning> {
  const kernel = await WasmSkinning.compile(await compileKernel());
  const positions = new Float32Array(mesh.vertexCount * 3);
  const normals = withNormals ? new Float32Array(mesh.vertexCount * 3) : null;
  const out = { positions, normals };
  const run = (): void => {
    if (!kernel.deform(method, mesh, skin, palette, out, plainUse)) throw new Error('no kernel');
  };
  return { positions, ...(normals && { normals }), run };
}
