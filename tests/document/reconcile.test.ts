import { describe, expect, it } from 'vitest';
import { setPose } from '../../src/document/edits.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { reconcile, selectActor } from '../../src/document/reconcile.ts';
import { selectedActor } from '../../src/document/selected-actor.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';

const [first, second] = Object.values(allRigs).map((rig) => characterOfRig(rig()));

const found = {
  ...{ position: 0, vertex: 0, normal: 0, identical: true },
  ...{ relative: 0, bindError: null, isOnCpu: false },
};

function start() {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  const open = (replaced: number | null, character = first!): void =>
    store.dispatch(openCharacter(replaced, character, 'linear-blend'));
  open(null);
  open(null);
  session.verification.value = found;
  return { session, store, open, selected: () => selectedActor(store, session)! };
}

describe('what a check found of the selected actor', () => {
  it('stays while that is posed', () => {
    const { session, store, selected } = start();
    store.dispatch(
      setPose(
        selected().id,
        selected().q.map((value) => value + 1),
      ),
    );
    expect(session.verification.value).toBe(found);
  });

  it.each<[string, (page: ReturnType<typeof start>) => void]>([
    ['another character takes its place', ({ open, selected }) => open(selected().id, second)],
    ['a copy of it is added', ({ open }) => open(null)],
    ['its opening is undone', ({ store }) => store.undo()],
    [
      'another actor is selected',
      ({ session, store }) => selectActor(session, store.scene.value, 1),
    ],
  ])('goes when %s', (_, happen) => {
    const page = start();
    happen(page);
    expect(page.session.verification.value).toBeNull();
  });
});
