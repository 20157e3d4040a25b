import { expect, it } from 'vitest';
import { openCharacters } from '../../src/document/open-characters.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { plainView, showView, viewStateOf } from '../../src/document/view-state.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';

const character = characterOfRig(rotatedTree());

function openTwo() {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  const actor = { character, method: 'linear-blend' } as const;
  store.dispatch(openCharacters([], [actor, actor]));
  return { session, scene: store.scene.value };
}

it('a view that is shown again selects and shows the same', () => {
  const { session, scene } = openTwo();
  session.selectedActorId.value = scene.actors[0]!.id;
  session.selectedJoint.value = 3;
  session.showSkeleton.value = true;
  session.skeletonStyle.value = 'boxes';
  session.clipTime.value = -0;
  const camera = { ...plainView.camera, azimuth: 1 };
  const view = viewStateOf(scene, session, camera, 'cse169');
  expect(view).toMatchObject({ camera, workspace: 'cse169', selected: 0 });
  expect(view.joint, 'the index in the file').toBe(character.skeleton.sourceIndex[3]);

  const other = openTwo();
  showView(other.scene, other.session, view);
  expect(viewStateOf(other.scene, other.session, camera, 'cse169')).toEqual(view);
});

it('a view of what the scene does not have selects nothing of it', () => {
  const { session, scene } = openTwo();
  const selected = session.selectedActorId.value;
  showView(scene, session, { ...plainView, selected: 7, joint: 99 });
  expect(session.selectedActorId.value).toBe(selected);
  showView(scene, session, { ...plainView, selected: 0, joint: 99 });
  expect(session.selectedJoint.value).toBeNull();
});
