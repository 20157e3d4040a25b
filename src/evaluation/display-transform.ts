import { mat4, vec3 } from 'gl-matrix';
import { extents, isEmpty } from '../core/bounds.ts';
import type { Character } from '../core/character.ts';
import { type Actor, unmoved } from '../document/scene.ts';

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
 * A fitted character is one unit tall whatever its file's units, with its feet on the floor y = 0
 * and its middle over the origin; another one stands as its file has it, one unit of the file being
 * one of the scene. The transform then scales, rotates and moves it from there.
 */
export function displayTransform(
  { bounds }: Pick<Character, 'bounds'>,
  { transform = unmoved, fitted = true }: Partial<Pick<Actor, 'transform' | 'fitted'>> = {},
): DisplayTransform {
  const { position, rotation } = transform;
  const sceneFromCharacter = new Float64Array(16);
  mat4.fromRotationTranslation(sceneFromCharacter, [...rotation], [...position]);
  const scale = (fitted ? fittedScale({ bounds }) : 1) * transform.scale;
  mat4.scale(sceneFromCharacter, sceneFromCharacter, [scale, scale, scale]);
  if (!fitted || isEmpty(bounds)) return { sceneFromCharacter, scale };
  const [width, , depth] = extents(bounds);
  const moved: vec3 = [
    -(bounds.min[0]! + width / 2),
    -bounds.min[1]!,
    -(bounds.min[2]! + depth / 2),
  ];
  sceneFromCharacter.set(vec3.transformMat4(moved, moved, sceneFromCharacter), 12);
  return { sceneFromCharacter, scale };
}

/** The factor that makes a character one unit tall: scene units per unit of its file. */
export function fittedScale({ bounds }: Pick<Character, 'bounds'>): number {
  if (isEmpty(bounds)) return 1;
  const [width, height, depth] = extents(bounds);
  const size = Math.max(height, flatness * width, flatness * depth);
  return size > 0 ? 1 / size : 1;
}
