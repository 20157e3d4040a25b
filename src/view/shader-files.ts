import type { ShaderFiles } from '../gl/shader-library.ts';

const files: Record<string, string> = {};

/** The shaders that are loaded, by their paths below shaders/. */
export const shaderFiles: ShaderFiles = files;

/**
 * @param found by the path from the importing file, which ends in shaders/ and the path below it
 */
export function addShaderFiles(found: Readonly<Record<string, string>>): void {
  for (const [path, source] of Object.entries(found)) {
    files[path.slice(path.lastIndexOf('shaders/') + 'shaders/'.length)] = source;
  }
}

// These are the shaders of the first picture; the passes that are loaded after it bring their own.
addShaderFiles(
  import.meta.glob<string>(
    [
      '../../shaders/lib/*.glsl',
      '!**/lib/quaternions.glsl',
      '../../shaders/skinning/{stage.*,linear-blend}.glsl',
      '../../shaders/passes/{backdrop,floor,key-shadow,mesh}.*.glsl',
    ],
    { query: '?raw', import: 'default', eager: true },
  ),
);
