import { type Bounds, extents, isEmpty } from '../core/bounds.ts';
import type { Character } from '../core/character.ts';
import { type Transform, unmoved } from '../document/scene.ts';
import { displayTransform } from './display-transform.ts';

/** Between neighbors, scene units, in which a character is one tall. */
const gap = 0.2;

/**
 * Places for characters in a row, at the right of all that stands already.
 *
 * @param taken the box about what stands, scene space
 */
export function placeInRow(taken: Bounds, characters: readonly Character[]): Transform[] {
  let edge = isEmpty(taken) ? null : taken.max[0]!;
  return characters.map((character) => {
    const place = edge === null ? unmoved : placeAt(edge + gap, character);
    edge = place.position[0] + widthOf(character) / 2;
    return place;
  });
}

/** With its left side at x. */
function placeAt(x: number, character: Character): Transform {
  return { ...unmoved, position: [x + widthOf(character) / 2, 0, 0] };
}

/** At the file's pose, scene units. */
function widthOf(character: Character): number {
  if (isEmpty(character.bounds)) return 0;
  return extents(character.bounds)[0] * displayTransform(character).scale;
}
