import { type Bounds, extents, isEmpty } from '../core/bounds.ts';
import type { Character } from '../core/character.ts';
import { type Transform, unmoved } from '../document/scene.ts';
import { fittedScale } from './display-transform.ts';

/** The distance between neighbors in scene units, in which a character is one unit tall. */
export const gap = 0.2;

/**
 * Returns places for characters in a row, to the right of everything that is in the scene.
 *
 * @param taken the box around what is in the scene, in scene space
 */
export function placeInRow(taken: Bounds, characters: readonly Character[]): Transform[] {
  let edge = isEmpty(taken) ? null : taken.max[0]!;
  return characters.map((character) => {
    const place = edge === null ? unmoved : placeAt(edge + gap, character);
    edge = place.position[0] + widthOf(character) / 2;
    return place;
  });
}

/** Places the character so that its left side is at x. */
function placeAt(x: number, character: Character): Transform {
  return { ...unmoved, position: [x + widthOf(character) / 2, 0, 0] };
}

/** The width in the file's pose, in scene units. */
function widthOf(character: Character): number {
  if (isEmpty(character.bounds)) return 0;
  return extents(character.bounds)[0] * fittedScale(character);
}
