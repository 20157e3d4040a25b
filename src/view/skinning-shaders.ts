import { loadPart } from '../core/failure.ts';
import type { SkinningMethod } from '../skinning/method.ts';
import { addShaderFiles } from './shader-files.ts';

const later = import.meta.glob<string>(
  ['../../shaders/skinning/*.glsl', '!**/stage.*.glsl', '!**/linear-blend.glsl'],
  { query: '?raw', import: 'default' },
);

/** Loads the GLSL chunk with which a kernel runs on the GPU. */
export async function loadSkinningShader({ chunk }: SkinningMethod): Promise<void> {
  const path = `../../shaders/skinning/${chunk}.glsl`;
  const load = later[path];
  if (load) addShaderFiles({ [path]: await loadPart(load()) });
}
