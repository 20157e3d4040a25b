import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { expect, it } from 'vitest';
import { setPose } from '../../src/document/edits.ts';
import { createActor, emptyScene } from '../../src/document/scene.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';

setFlagsFromString('--expose-gc');
const collectGarbage = runInNewContext('gc') as () => void;

it('the history keeps states, and no computed results', async () => {
  const store = new Store();
  const evaluations = new Evaluations(store, new Session());
  const character = characterOfRig(rotatedTree());
  store.dispatch({
    label: 'Open',
    apply: () => ({ ...emptyScene, actors: [createActor(1, character, 'linear-blend')] }),
  });
  const computed = Array.from({ length: 3 }, (_, pose) => {
    store.dispatch(
      setPose(
        1,
        character.skeleton.qRest.map((value) => value + 0.1 * pose),
      ),
    );
    return arraysOf(evaluations);
  }).flat();
  store.dispatch({ label: 'Remove', apply: () => emptyScene });
  evaluations.keepOnly([]);
  // The target of a weak reference lives until the end of the task that created it.
  await new Promise((resolve) => setTimeout(resolve));
  collectGarbage();
  expect(computed.filter((reference) => reference.deref() !== undefined)).toEqual([]);
  store.undo();
  expect(store.scene.value.actors[0]?.character).toBe(character);
});

function arraysOf(evaluations: Evaluations): WeakRef<object>[] {
  const [shown] = evaluations.all();
  const arrays = [shown!.vertices().positions, shown!.palette, shown!.characterFromJoint];
  return arrays.map((array) => new WeakRef(array));
}
