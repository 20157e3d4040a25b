import { mat4 } from 'gl-matrix';
import { extents, isEmpty } from '../core/bounds.ts';
import type { Character } from '../core/character.ts';

/**
 * How a character stands in the scene: one unit tall whatever its file's units, feet on the floor
 * y = 0, its middle over the origin. The scale is even in all directions.
 */
export interface DisplayTransform {
  /** Column-major, float64. */
  readonly sceneFromCharacter: Float64Array;
  readonly scale: number;
}

/** Of what lies flat, the width counts, so that it does not fill the room. */
const flatness = 0.5;

export function displayTransform({ bounds }: Character): DisplayTransform {
  const sceneFromCharacter = new Float64Array(16);
  mat4.identity(sceneFromCharacter);
  if (isEmpty(bounds)) return { sceneFromCharacter, scale: 1 };
  const [width, height, depth] = extents(bounds);
  const size = Math.max(height, flatness * width, flatness * depth);
  const scale = size > 0 ? 1 / size : 1;
  mat4.scale(sceneFromCharacter, sceneFromCharacter, [scale, scale, scale]);
  mat4.translate(sceneFromCharacter, sceneFromCharacter, [
    -(bounds.min[0]! + width / 2),
    -bounds.min[1]!,
    -(bounds.min[2]! + depth / 2),
  ]);
  return { sceneFromCharacter, scale };
}
