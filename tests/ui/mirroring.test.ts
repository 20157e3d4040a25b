import { signal } from '@preact/signals-core';
import { expect, it } from 'vitest';
import { jointRange } from '../../src/core/pose.ts';
import { setPose } from '../../src/document/edits.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { selectJoint, selectJoints } from '../../src/document/select-joints.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import type { Editor } from '../../src/ui/editor.ts';
import { setLiveSymmetry } from '../../src/ui/live-symmetry.ts';
import { mirrorInPlace, mirrorOnto, mirrorRemarks } from '../../src/ui/mirroring.ts';
import { pasteText } from '../../src/ui/paste-pose.ts';
import { copiedPose } from '../../src/ui/pose-clipboard.ts';
import { bundled, randomPose } from '../posing/symmetry/mirror-laws.ts';

/** An editor with what copying and mirroring use, and a character in a random pose. */
async function start(id: string) {
  const character = await bundled(id);
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  store.dispatch(openCharacter(null, character, 'linear-blend'));
  const evaluations = new Evaluations(store, session);
  const editor = { store, session, evaluations, notice: signal('') } as unknown as Editor;
  const { skeleton } = character;
  const jointOf = (name: string): number => skeleton.names.indexOf(name);
  const actor = () => store.scene.value.actors[0]!;
  const valuesOf = (name: string): Float64Array =>
    actor().q.subarray(...jointRange(skeleton, jointOf(name)));
  const pose = randomPose(skeleton, 7);
  store.dispatch(setPose(actor().id, pose));
  return { editor, store, session, skeleton, jointOf, actor, valuesOf, pose };
}

it('copies and pastes a branch onto the other side, and leaves the rest', async () => {
  const { editor, store, session, jointOf, actor, valuesOf, pose } = await start('human');
  selectJoint(session, jointOf('Left forearm'));
  session.poseScope.value = 'branch';
  const { text, name } = copiedPose(editor)!;
  expect(name).toBe('Left forearm');
  expect(Object.keys((JSON.parse(text) as { joints: object }).joints)).toEqual([
    ...['Left forearm', 'Left hand', 'Left palm', 'Left fingers', 'Left thumb'],
  ]);
  pasteText(editor, text, false);
  expect(actor().q).toEqual(pose);
  pasteText(editor, text, true);
  for (const part of ['forearm', 'hand', 'palm', 'fingers', 'thumb']) {
    const [x, y, z] = valuesOf(`Left ${part}`);
    expect([...valuesOf(`Right ${part}`)]).toEqual([x, -y!, -z!]);
  }
  expect(editor.notice.value).toBe('Pose pasted mirrored');
  store.undo();
  expect(actor().q).toEqual(pose);
});

it('pastes what is at rest too, and only that of the root which is named', async () => {
  const { editor, session, jointOf, valuesOf, pose, skeleton } = await start('human');
  selectJoint(session, jointOf('Head'));
  session.poseScope.value = 'selected';
  pasteText(editor, JSON.stringify({ joints: { Head: [0, 0, 0] } }), false);
  expect([...valuesOf('Head')]).toEqual([0, 0, 0]);
  pasteText(editor, copiedPose(editor)!.text, false);
  expect([...valuesOf('Head')]).toEqual([0, 0, 0]);
  pasteText(editor, JSON.stringify({ root: [0.1, 0.2, 0.3] }), true);
  const turn = pose.subarray(...jointRange(skeleton, 0)).subarray(3);
  expect([...valuesOf('Root')]).toEqual([-0.1, 0.2, 0.3, ...turn]);
});

it('leaves the pose as it is where a text names a joint that is not there', async () => {
  const { editor, session, actor, pose } = await start('human');
  for (const isMirrored of [false, true]) {
    pasteText(editor, JSON.stringify({ joints: { Head: [1, 0, 0], Tail: [1, 0, 0] } }), isMirrored);
    expect(actor().q).toEqual(pose);
    expect(editor.notice.value).toBe('The pose was not pasted; Problems says why');
    expect(session.problems.value.map(({ code }) => code)).toEqual(['pose/unknown-joint']);
  }
});

it('says what could not be mirrored', () => {
  expect(mirrorRemarks({ alone: [], stopped: [] })).toBe('');
  expect(mirrorRemarks({ alone: [4], stopped: [2, 3] })).toBe(
    '; 1 joint has no partner; 2 joints stopped at a limit',
  );
});

it('mirrors one hand onto the other from whichever is selected, and says so', async () => {
  const { editor, session, jointOf, valuesOf, pose, skeleton } = await start('human');
  session.poseScope.value = 'branch';
  selectJoint(session, jointOf('Right hand'));
  mirrorOnto(editor, 'left');
  expect(editor.notice.value).toBe('Left hand mirrored onto Right hand');
  const [x, y, z] = valuesOf('Left fingers');
  expect([...valuesOf('Right fingers')]).toEqual([x, -y!, -z!]);
  const forearm = pose.subarray(...jointRange(skeleton, jointOf('Right forearm')));
  expect(valuesOf('Right forearm')).toEqual(forearm);
});

it('mirrors all, is taken back by mirroring again, and counts who has no partner', async () => {
  const { editor, session, jointOf, actor, pose } = await start('human');
  mirrorInPlace(editor);
  expect(editor.notice.value).toBe('The pose is mirrored');
  expect(actor().q).not.toEqual(pose);
  mirrorInPlace(editor);
  expect(actor().q).toEqual(pose);
  session.poseScope.value = 'selected';
  selectJoints(session, [jointOf('Left foot'), jointOf('Head')]);
  mirrorInPlace(editor);
  expect(editor.notice.value).toBe('2 joints mirrored');

  const { editor: hand } = await start('hand');
  mirrorInPlace(hand);
  expect(hand.notice.value).toBe('hand has no left and right here to mirror');
});

it('lets any gesture pose both sides while it is on, as one step', async () => {
  const { editor, store, session, jointOf, actor, valuesOf, pose, skeleton } =
    await start('insect');
  setLiveSymmetry(editor, true);
  selectJoint(session, jointOf('wing_l'));
  expect(session.mirroredJoints.value).toEqual([jointOf('wing_r')]);
  const gesture = store.begin('Turn');
  const q = pose.slice();
  const [at] = jointRange(skeleton, jointOf('wing_l'));
  for (const angle of [0.1, 0.6]) {
    q[at] = angle;
    gesture.preview(setPose(actor().id, q));
  }
  gesture.commit();
  const [z, y, x] = valuesOf('wing_l');
  expect(z).toBe(0.6);
  expect([...valuesOf('wing_r')]).toEqual([-z!, -y!, x]);
  store.undo();
  expect(actor().q).toEqual(pose);
  setLiveSymmetry(editor, false);
  expect(session.mirroredJoints.value).toEqual([]);
  store.dispatch(setPose(actor().id, q));
  expect(actor().q).toEqual(q);
});
