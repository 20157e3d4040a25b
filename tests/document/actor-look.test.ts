import { expect, it } from 'vitest';
import { clayCount, nextClay } from '../../src/document/actor-look.ts';
import { setLook } from '../../src/document/look-edits.ts';
import { openCharacter, openCharacters } from '../../src/document/open-characters.ts';
import { emptyScene } from '../../src/document/scene.ts';
import { Store } from '../../src/document/store.ts';
import { palette } from '../../src/view/theme.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';

const character = characterOfRig(Object.values(allRigs)[0]!());
const method = 'linear-blend';

it('there is a clay for every index', () => {
  expect(palette.clays).toHaveLength(clayCount);
});

it('characters get one clay after another, and one that is free again', () => {
  const looks: { clay: number }[] = [];
  for (let i = 0; i < clayCount; i++) looks.push({ clay: nextClay(looks) });

  expect(looks.map(({ clay }) => clay)).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
  expect(nextClay(looks)).toBe(0);
  expect(nextClay(looks.filter(({ clay }) => clay !== 5))).toBe(5);
});

it('characters that are opened together differ, and one that replaces another looks like it', () => {
  const both = openCharacters(
    [],
    [
      { character, method },
      { character, method, look: { shading: 'faceted' } },
    ],
  ).apply(emptyScene);
  const [first, second] = both.actors;
  const replaced = openCharacter(first!.id, character, method).apply(both);

  expect(both.actors.map(({ look }) => look.clay)).toEqual([0, 1]);
  expect(second!.look.shading).toBe('faceted');
  expect(replaced.actors.map(({ look }) => look.clay)).toEqual([1, 0]);
});

it('an equal look is no step of undo, and another one is undone', () => {
  const store = new Store();
  store.dispatch(openCharacter(null, character, method));
  const [actor] = store.scene.value.actors;
  store.dispatch(setLook(actor!.id, { visible: true, clay: 0 }, 'the same'));
  expect(store.undoLabel.value).toBeNull();

  store.dispatch(setLook(actor!.id, { visible: false }, 'Hide'));
  expect(store.scene.value.actors[0]!.look.visible).toBe(false);
  store.undo();
  expect(store.scene.value.actors[0]!.look).toEqual(actor!.look);
});
