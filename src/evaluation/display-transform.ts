import { mat4 } from 'gl-matrix';
import { extents, isEmpty } from '../core/bounds.ts';
import type { Character } from '../core/character.ts';
import { type Transform, unmoved } from '../document/scene.ts';

/** How a character stands in the scene. The scale is even in all directions. */
export interface DisplayTransform {
  /** Column-major, float64. */
  readonly sceneFromCharacter: Float64Array;
  readonly scale: number;
}

/** Of what lies flat, the width counts, so that it does not fill the room. */
const flatness = 0.5;

/**
 * By itself a character stands one unit tall whatever its file's units, feet on the floor y = 0, its
 * middle over the origin; there it is sized, turned and moved.
 */
export function displayTransform(
  { bounds }: Pick<Character, 'bounds'>,
  transform: Transform = unmoved,
): DisplayTransform {
  const { position, rotation } = transform;
  const sceneFromCharacter = new Float64Array(16);
  mat4.fromRotationTranslation(sceneFromCharacter, [...rotation], [...position]);
  const standing = isEmpty(bounds) ? 1 : standingScale(extents(bounds));
  const scale = standing * transform.scale;
  mat4.scale(sceneFromCharacter, sceneFromCharacter, [scale, scale, scale]);
  if (isEmpty(bounds)) return { sceneFromCharacter, scale };
  const [width, , depth] = extents(bounds);
  mat4.translate(sceneFromCharacter, sceneFromCharacter, [
    -(bounds.min[0]! + width / 2),
    -bounds.min[1]!,
    -(bounds.min[2]! + depth / 2),
  ]);
  return { sceneFromCharacter, scale };
}

function standingScale([width, height, depth]: readonly [number, number, number]): number {
  const size = Math.max(height, flatness * width, flatness * depth);
  return size > 0 ? 1 / size : 1;
}
