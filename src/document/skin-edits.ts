import type { Character } from '../core/character.ts';
import { sameValue } from '../core/same-value.ts';
import { type Influence, influencesOf, type Skin, skinWithRows } from '../core/skin.ts';
import { type Edit, editActor } from './edit.ts';
import type { Actor, ActorId } from './scene.ts';

/** The influences of some points. */
export type ChangedRows = ReadonlyMap<number, readonly Influence[]>;

/** The weights that the user edits: those of the file with the changes so far. */
export function editedSkin({ skin, character }: Actor): Skin {
  return skin ?? character.skin;
}

/** Gives points other influences. */
export function setInfluencesOf(id: ActorId, rows: ChangedRows, label: string): Edit {
  return editActor(id, label, (actor) => ({
    ...actor,
    skin: changedSkin(actor.character, editedSkin(actor), rows),
  }));
}

/** Gives a point the influences of its file again. */
export function resetInfluencesOf(id: ActorId, point: number): Edit {
  return editActor(id, `Reset the weights of vertex ${point}`, (actor) => {
    const rows = new Map([[point, influencesOf(actor.character.skin, point)]]);
    return { ...actor, skin: changedSkin(actor.character, editedSkin(actor), rows) };
  });
}

/** Takes all changes of weights back. */
export function resetSkin(id: ActorId): Edit {
  return editActor(id, 'Reset all weights', (actor) => ({ ...actor, skin: null }));
}

/** The skin with other rows, or null if it then is that of the file. */
export function changedSkin(
  { skin: ofFile }: Pick<Character, 'skin'>,
  skin: Skin,
  rows: ChangedRows,
): Skin | null {
  const points = [...rows.keys()].sort((a, b) => a - b);
  const start = [0];
  const influences: Influence[] = [];
  for (const point of points) {
    influences.push(...rows.get(point)!);
    start.push(influences.length);
  }
  const changed = skinWithRows(skin, points, {
    start,
    entries: influences.map(({ entry }) => entry),
    weights: influences.map(({ weight }) => weight),
  });
  return haveSameRows(changed, ofFile) ? null : changed;
}

function haveSameRows(a: Skin, b: Skin): boolean {
  return (
    sameValue(a.start, b.start) &&
    sameValue(a.entries, b.entries) &&
    sameValue(a.weights, b.weights)
  );
}
