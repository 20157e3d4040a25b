import { expect, it } from 'vitest';
import { startCamera } from '../../src/document/camera.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { Session } from '../../src/document/session.ts';
import { addShot, changeShot, newShot, removeShot } from '../../src/document/shots.ts';
import { Store } from '../../src/document/store.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';

function start() {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  store.dispatch(openCharacter(null, characterOfRig(rotatedTree()), 'linear-blend'));
  const take = () => {
    const shot = newShot(store.scene.value, startCamera, '4:5');
    store.dispatch(addShot(shot));
    return shot;
  };
  return { session, store, take, shots: () => store.scene.value.shots };
}

it('shots get ids and names of their own, also after some were removed', () => {
  const { store, take, shots } = start();
  const [first] = [take(), take()];
  store.dispatch(removeShot(first));
  take();
  expect(shots().map(({ id }) => id)).toEqual([2, 3]);
  expect(shots().map(({ name }) => name)).toEqual(['Shot 2', 'Shot 3']);
});

it('every change of a shot is a step of undo that restores it', () => {
  const { store, take, shots } = start();
  const { id } = take();
  const before = shots();
  const camera = { ...startCamera, azimuth: 1 };
  store.dispatch(changeShot(id, { camera }, 'Update'));
  store.dispatch(changeShot(id, { aspect: 'A4', name: 'Cover' }, 'Change'));
  expect(shots()).toEqual([{ id, name: 'Cover', aspect: 'A4', camera }]);
  store.undo();
  store.undo();
  expect(shots()).toBe(before);
  store.dispatch(changeShot(id, { aspect: '4:5' }, 'Nothing'));
  expect(store.undoLabel.value).toBe('Add Shot 1');
});

it('the frame of a shot that is gone is not shown any more', () => {
  const { session, store, take } = start();
  const { id } = take();
  session.shownShot.value = id;
  store.dispatch(changeShot(id, { name: 'Cover' }, 'Rename'));
  expect(session.shownShot.value).toBe(id);
  store.undo();
  store.undo();
  expect(session.shownShot.value).toBeNull();
});
