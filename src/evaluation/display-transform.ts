import { mat4 } from 'gl-matrix';
import { extents, isEmpty } from '../core/bounds.ts';
import type { Character } from '../core/character.ts';
import { type Transform, unmoved } from '../document/scene.ts';

/** How a character is placed in the scene. The scale is uniform. */
export interface DisplayTransform {
  /** Column-major, float64. */
  readonly sceneFromCharacter: Float64Array;
  readonly scale: number;
}

/**
 * Width and depth count by this factor, so that a character that lies flat does not fill the view.
 */
const flatness = 0.5;

/**
 * Without a transform, a character is one unit tall whatever its file's units, with its feet on the
 * floor y = 0 and its middle over the origin. The transform then scales, rotates and moves it from
 * there.
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
