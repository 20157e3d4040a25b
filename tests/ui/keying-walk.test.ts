import { signal } from '@preact/signals-core';
import fc from 'fast-check';
import { expect, it } from 'vitest';
import { setMorphWeight, setPose } from '../../src/document/edits.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { movePin, pinJoints } from '../../src/document/pin-edits.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { boundClip, type Scene, sameScene } from '../../src/document/scene.ts';
import { selectedActor } from '../../src/document/selected-actor.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Transport } from '../../src/document/transport.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { holdEdits } from '../../src/evaluation/hold-edits.ts';
import { settlePins } from '../../src/evaluation/settle-pins.ts';
import { shownPins, shownState } from '../../src/evaluation/shown-state.ts';
import { toggleAutoKey } from '../../src/ui/auto-key.ts';
import { copyClip, deleteClip, makeClip, nameClip, setRange, setRate } from '../../src/ui/clips.ts';
import type { Editor } from '../../src/ui/editor.ts';
import { setKeyHere } from '../../src/ui/set-key.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';
import { withMorph } from '../fixtures/with-morph.ts';
import { allThere } from '../support/kernels.ts';

const character = withMorph(characterOfRig(rotatedTree()));
const { qMin, qMax } = character.skeleton;

/** How far what is shown may be from what was keyed. */
const tolerance = 1e-12;

/** The parts of an editor that keying needs, as the page connects them. */
function open(count: number) {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  const evaluations = new Evaluations(store, session, allThere);
  store.settle = (scene) => settlePins(scene, evaluations);
  holdEdits(store, session, evaluations);
  const notice = signal('');
  const transport = new Transport(store, session, (message) => (notice.value = message));
  const parts: Pick<Editor, 'store' | 'session' | 'evaluations' | 'notice' | 'transport'> = {
    store,
    session,
    evaluations,
    notice,
    transport,
  };
  for (let each = 0; each < count; each++) {
    store.dispatch(openCharacter(null, character, 'linear-blend'));
  }
  return parts as Editor;
}

const shownOf = (editor: Editor) => shownState(editor.evaluations.selected()!);
const actorOf = ({ store, session }: Editor) => selectedActor(store, session)!;
const stepsOf = ({ store }: Editor) => store.history.value.past.length;

/** Changes one number of the pose within its limits; balls stay units. */
function turn(editor: Editor, number: number): void {
  const { id } = actorOf(editor);
  const q = shownOf(editor).q.slice();
  const free = [...q.keys()].filter((at) => qMin[at] !== qMax[at]);
  const at = free[number % free.length]!;
  const wanted = ((number % 97) / 97 - 0.5) * 2;
  q[at] = Math.min(Math.max(wanted, qMin[at]!), qMax[at]!);
  const { dofKind, dofQ } = character.skeleton;
  dofKind.forEach((kind, dof) => {
    if (kind !== 2) return;
    const ball = q.subarray(dofQ[dof], dofQ[dof]! + 4);
    const length = Math.hypot(...ball);
    if (length > 0) ball.forEach((part, i) => (ball[i] = part / length));
    else ball.set([0, 0, 0, 1]);
  });
  editor.store.dispatch(setPose(id, q, 'Turn'));
}

/** What a user does next; the number chooses among the possible targets. */
const actions: readonly ((editor: Editor, number: number) => void)[] = [
  turn,
  turn,
  turn,
  (editor, number) => {
    const weight = (number % 11) / 10;
    const { morphWeights } = shownOf(editor);
    editor.store.dispatch(setMorphWeight(actorOf(editor).id, morphWeights, 0, weight, 'Shape'));
  },
  (editor, number) => {
    const shown = shownPins(editor.evaluations.selected()!);
    const joint = number % character.skeleton.jointCount;
    const pin = shown.state.pins.find((each) => each.joint === joint);
    if (!pin) editor.store.dispatch(pinJoints(shown, [joint]));
    else {
      const [x, y, z] = pin.place;
      editor.store.dispatch(movePin(shown.state, joint, [x + 0.01 * (number % 7), y, z]));
    }
  },
  (editor, number) => editor.transport.seek((number % 100) / 30),
  (editor, number) => editor.transport.seek((number % 60) / 30),
  (editor, number) => editor.transport.step(number % 2 === 0 ? 1 : -1),
  ({ session }, number) => {
    session.selectedJoint.value = number % 3 === 0 ? null : number % character.skeleton.jointCount;
  },
  setKeyHere,
  setKeyHere,
  (editor) => toggleAutoKey(editor),
  ({ transport }) => transport.togglePlay(),
  ({ transport }) => transport.pass(0.3),
  ({ transport }) => transport.playAll(),
  (editor) => editor.transport.release(shownOf(editor)),
  makeClip,
  copyClip,
  deleteClip,
  (editor, number) => nameClip(editor, `clip ${number}`),
  (editor, number) => setRange(editor, 'end', (number % 90) / 30),
  (editor, number) => setRate(editor, [24, 25, 30, 60][number % 4]!),
  ({ transport, store, session }, number) => {
    const { clips } = selectedActor(store, session)!;
    if (clips.length > 0) transport.choose(number % clips.length);
  },
  ({ store, session }, number) => {
    session.selectedActorId.value =
      store.scene.value.actors[number % store.scene.value.actors.length]!.id;
  },
  ({ store }) => store.undo(),
  ({ store }) => store.redo(),
];

const steps = fc.array(fc.tuple(fc.nat(actions.length - 1), fc.nat(1000)), { maxLength: 60 });

/** What every panel and the evaluation assume. */
function expectFits(editor: Editor): void {
  const { store, session, transport, evaluations } = editor;
  for (const actor of store.scene.value.actors) {
    if (actor.clip !== null) expect(boundClip(actor)).toBeDefined();
    else expect(actor.unkeyed).toBeNull();
    for (const { start, end, channels } of actor.clips) {
      expect(end).toBeGreaterThan(start);
      for (const { keys } of channels) {
        keys.forEach(({ time }, at) => {
          if (at > 0) expect(time).toBeGreaterThan(keys[at - 1]!.time);
        });
      }
    }
    for (const value of evaluations.of(actor).pose.q) expect(Number.isFinite(value)).toBe(true);
  }
  const { clips } = actorOf(editor);
  expect(clips.length === 0 || clips[transport.clipIndex] !== undefined).toBe(true);
  expect(clips.length === 0 || clips[session.clipIndex.value] !== undefined).toBe(true);
  if (session.playing.value)
    expect(store.scene.value.actors.some(({ clip }) => clip !== null)).toBe(true);
}

it('fits after any run of edits, keys, seeks, clips, undo and redo', () => {
  fc.assert(
    fc.property(steps, (chosen) => {
      const editor = open(2);
      for (const [action, number] of chosen) {
        const before = stepsOf(editor);
        actions[action]!(editor, number);
        expectFits(editor);
        expect(stepsOf(editor) - before, 'an action is one step at most').toBeLessThanOrEqual(1);
      }
    }),
    { numRuns: 150 },
  );
});

/** A quaternion and its opposite are one rotation: −1 for the numbers of those that are opposite. */
function signsOfBalls(before: Float64Array, after: Float64Array): Float64Array {
  const signs = new Float64Array(after.length).fill(1);
  const { dofKind, dofQ } = character.skeleton;
  dofKind.forEach((kind, dof) => {
    if (kind !== 2) return;
    const at = dofQ[dof]!;
    let dot = 0;
    for (let i = at; i < at + 4; i++) dot += before[i]! * after[i]!;
    if (dot < 0) signs.fill(-1, at, at + 4);
  });
  return signs;
}

it('shows the same right after k as before', () => {
  fc.assert(
    fc.property(steps, (chosen) => {
      const editor = open(2);
      for (const [action, number] of chosen) actions[action]!(editor, number);
      editor.session.playing.value = false;
      editor.session.autoKey.value = false;
      // Between frames the playhead goes to the frame of the key.
      editor.session.snapsToFrames.value = false;
      const before = shownOf(editor);
      setKeyHere(editor);
      const after = shownOf(editor);
      // A pin out of reach lets its limb come nearer from whatever pose the keys hold.
      const isFree = before.pins.length === 0;
      const signs = signsOfBalls(before.q, after.q);
      after.q.forEach((value, at) => {
        const difference = Math.abs(signs[at]! * value - before.q[at]!);
        if (isFree) expect(difference).toBeLessThanOrEqual(tolerance);
      });
      expect([...after.morphWeights]).toEqual([...before.morphWeights]);
      expect(after.pins.map(({ place }) => place)).toEqual(before.pins.map(({ place }) => place));
      expect(actorOf(editor).unkeyed?.values ?? []).toEqual([]);
    }),
    { numRuns: 150 },
  );
});

it('undoes 300 random edits of poses, keys and clips byte for byte', () => {
  const editor = open(1);
  const { store, session } = editor;
  session.clipIndex.value = 0;
  setKeyHere(editor);
  const scenes: Scene[] = [store.scene.value];
  const walk = fc.sample(fc.tuple(fc.nat(9), fc.nat(1000)), { numRuns: 3000, seed: 7 });
  const edits = [turn, turn, setKeyHere, setKeyHere, makeClip, copyClip, deleteClip];
  for (const [action, number] of walk) {
    if (scenes.length > 300) break;
    if (action === 7) toggleAutoKey(editor);
    // Leaving a moment is a step too, when it drops something.
    else if (action === 8) session.clipTime.value = (number % 60) / 30;
    else edits[action % edits.length]!(editor, number);
    if (store.scene.value !== scenes.at(-1)) scenes.push(store.scene.value);
  }
  expect(scenes.length).toBeGreaterThan(300);
  expect(stepsOf(editor)).toBe(scenes.length);
  for (const scene of scenes.toReversed()) {
    expect(sameScene(store.scene.value, scene)).toBe(true);
    store.undo();
  }
  for (const scene of scenes) {
    store.redo();
    expect(sameScene(store.scene.value, scene)).toBe(true);
  }
});

it('keys a gesture when it ends, as one step with it, and makes the clip', () => {
  const editor = open(1);
  const { store, session } = editor;
  toggleAutoKey(editor);
  const before = store.scene.value;
  const gesture = store.begin('Drag');
  for (const number of [3, 5, 8]) {
    const q = actorOf(editor).q.slice();
    q[0] = 0.01 * number;
    gesture.preview(setPose(actorOf(editor).id, q, 'Drag'));
    expect(actorOf(editor).clips).toHaveLength(0);
  }
  gesture.commit();
  expect(actorOf(editor).clips[0]!.channels).toHaveLength(1);
  expect(actorOf(editor)).toMatchObject({ clip: 0, unkeyed: null });
  expect(shownOf(editor).q[0]).toBe(0.08);
  session.clipTime.value = 1;
  turn(editor, 1);
  expect(actorOf(editor).unkeyed).toBeNull();
  expect(stepsOf(editor)).toBe(2);
  store.undo();
  store.undo();
  expect(store.scene.value).toBe(before);
});
