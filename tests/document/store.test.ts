import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { buildCharacter } from '../../src/core/build-character.ts';
import { setInfluences } from '../../src/document/weight-edits.ts';
import type { Character } from '../../src/core/character.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import {
  bindClip,
  resetJoints,
  resetPose,
  setMethod,
  setMorphWeight,
  setNormalizeWeights,
  setPose,
  setValue,
} from '../../src/document/edits.ts';
import { setTransform } from '../../src/document/place-edits.ts';
import type { Edit } from '../../src/document/edit.ts';
import { allSteps } from '../../src/document/history.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { type Actor, type Scene, type Transform, unmoved } from '../../src/document/scene.ts';
import { Store } from '../../src/document/store.ts';
import { methods } from '../../src/skinning/registry.ts';
import { partsOfRig } from '../fixtures/character-of-rig.ts';
import type { Rig } from '../fixtures/rig.ts';
import { allRigs } from '../fixtures/rigs.ts';

const characters = Object.values(allRigs).map((rig) => withMorphAndClip(rig()));

/** The rig with a morph and a clip. */
function withMorphAndClip(rig: Rig): Character {
  const parts = partsOfRig(rig);
  const file = 'made';
  const point = Uint32Array.of(0);
  const offset = Float32Array.of(0, 1, 0);
  const shape = { points: point, offsets: offset, normalPoints: point, normalOffsets: offset };
  const key = { tangentIn: 'smooth', tangentOut: 'smooth' } as const;
  // The root of the first rig, 'rotated tree'; the clip moves no other rig.
  const target = { of: 'value', joint: 8, kind: DofKind.hinge, axis: 0 } as const;
  const keys = [
    { time: 0, value: 0, ...key },
    { time: 2, value: 1, ...key },
  ];
  const channel = { target, before: 'constant', after: 'constant', keys } as const;
  return buildCharacter({
    ...parts,
    morphs: [{ file, name: 'up', ...shape }],
    clips: [{ file, name: 'turn', start: 0, end: 2, fps: 30, channels: [channel] }],
  }).value!;
}

function openStore(): Store {
  const store = new Store();
  store.dispatch(openCharacter(null, characters[0]!, 'linear-blend'));
  return store;
}

function selected(store: Store): Actor {
  return store.scene.value.actors.at(-1)!;
}

function turn(store: Store, index: number, value: number, label = 'turn'): Edit {
  const { id, q } = selected(store);
  return setValue(id, q, index, value, label);
}

/** Everything in a scene, to the bit: floats as hexadecimal bytes. */
function bits({ actors }: Scene): string {
  const parts = actors.map(
    ({ id, character, transform, q, morphWeights, clip, method, normalizeWeights, influences }) => [
      id,
      characters.indexOf(character),
      ...[q, morphWeights, placeOf(transform)].map(({ buffer }) =>
        Buffer.from(buffer).toString('hex'),
      ),
      clip,
      method,
      normalizeWeights,
      influences,
    ],
  );
  return JSON.stringify(parts);
}

/** −0 and 0 are different positions, as for the store. */
function placeOf({ position, rotation, scale }: Transform): Float64Array {
  return Float64Array.of(...position, ...rotation, scale);
}

/** An edit of any kind for the selected character. */
function commandOf(store: Store, kind: number, amount: number): Edit {
  const { id, q, character } = selected(store);
  const index = Math.abs(Math.trunc(amount * 1e6)) % q.length;
  const joint = index % character.skeleton.jointCount;
  const kinds: (() => Edit)[] = [
    () => turn(store, index, amount),
    () =>
      setPose(
        id,
        q.map((value) => value + amount),
      ),
    () => resetPose(id),
    () => resetJoints(selected(store), q, [joint], 'reset'),
    () => setMethod(id, methods[index % methods.length]!.id),
    () => setNormalizeWeights(id, amount > 0),
    () => setInfluences(id, amount > 0 ? 1 + Math.trunc(amount) : null),
    () => openCharacter(id, characters[index % characters.length]!, 'rigid'),
    () => openCharacter(null, characters[index % characters.length]!, 'linear-blend'),
    () => setTransform(id, { ...unmoved, position: [amount, 0, 0] }, 'move'),
    () =>
      setMorphWeight(
        id,
        selected(store).morphWeights,
        index % character.morphs.length,
        amount,
        'morph',
      ),
    () => bindClip(id, amount > 0 ? 0 : null),
  ];
  return kinds[kind % kinds.length]!();
}

const step = fc.tuple(fc.nat(100), fc.double({ noNaN: true, min: -10, max: 10 }));

describe('the store', () => {
  it('undoes and redoes any run of commands to the bit', () => {
    fc.assert(
      fc.property(fc.array(step, { maxLength: 40 }), (steps) => {
        const store = openStore();
        const seen = [bits(store.scene.value)];
        for (const [kind, amount] of steps) {
          store.dispatch(commandOf(store, kind, amount));
          // An edit that changes nothing is not a step.
          const now = bits(store.scene.value);
          if (now !== seen.at(-1)) seen.push(now);
        }
        for (const expected of seen.slice(0, -1).reverse()) {
          store.undo();
          expect(bits(store.scene.value)).toBe(expected);
        }
        for (const expected of seen.slice(1)) {
          store.redo();
          expect(bits(store.scene.value)).toBe(expected);
        }
      }),
    );
  });

  it('goes to any step, with the very scene that it had there, and from there to any other', () => {
    const walk = fc.array(fc.nat(40), { maxLength: 20 });
    fc.assert(
      fc.property(fc.array(step, { maxLength: 30 }), walk, (steps, counts) => {
        const store = openStore();
        const seen = [store.scene.value];
        for (const [kind, amount] of steps) {
          store.dispatch(commandOf(store, kind, amount));
          if (store.scene.value !== seen.at(-1)) seen.push(store.scene.value);
        }
        const texts = seen.map(bits);
        const labels = allSteps(store.history.value).map(({ label }) => label);
        expect(labels).toHaveLength(seen.length - 1);
        for (const wanted of counts) {
          const count = wanted % seen.length;
          store.goTo(count);
          expect(store.scene.value).toBe(seen[count]);
          expect(bits(store.scene.value)).toBe(texts[count]);
          expect(store.undoLabel.value).toBe(labels[count - 1] ?? null);
          expect(store.redoLabel.value).toBe(labels[count] ?? null);
          expect(allSteps(store.history.value).map(({ label }) => label)).toEqual(labels);
        }
        const present = store.scene.value;
        for (const out of [-1, seen.length, 1e9]) store.goTo(out);
        expect(store.scene.value).toBe(present);
      }),
    );
  });

  it('commits an open gesture before it goes to another step', () => {
    const store = openStore();
    store.dispatch(turn(store, 0, 1, 'first'));
    const gesture = store.begin('second');
    gesture.preview(turn(store, 0, 2));
    store.goTo(0);
    expect(gesture.isOpen).toBe(false);
    expect(allSteps(store.history.value).map(({ label }) => label)).toEqual(['first', 'second']);
    expect([store.undoLabel.value, store.redoLabel.value]).toEqual([null, 'first']);
  });

  it('keeps the first character: an empty page is nothing to go back to', () => {
    const store = openStore();
    expect(store.undoLabel.value).toBeNull();
    store.undo();
    expect(selected(store).character).toBe(characters[0]);
  });

  it('makes one entry of a gesture, however many previews it has', () => {
    const store = openStore();
    const before = bits(store.scene.value);
    const gesture = store.begin('Turn elbow X');
    for (let i = 1; i <= 20; i++) gesture.preview(turn(store, 0, i / 10));
    gesture.commit();
    expect(selected(store).q[0]).toBe(2);
    expect(store.undoLabel.value).toBe('Turn elbow X');
    store.undo();
    expect(bits(store.scene.value)).toBe(before);
    expect(store.undoLabel.value).toBeNull();
    expect(store.redoLabel.value).toBe('Turn elbow X');
  });

  it('restores the exact bits when a gesture is canceled, and records nothing', () => {
    const store = openStore();
    const before = store.scene.value;
    const gesture = store.begin('Turn');
    gesture.preview(turn(store, 0, Math.PI / 7));
    expect(store.cancelGesture()).toBe(true);
    expect(store.scene.value).toBe(before);
    expect(store.undoLabel.value).toBeNull();
    expect(gesture.isOpen).toBe(false);
  });

  it('ignores previews of a gesture that an undo has ended', () => {
    const store = openStore();
    const gesture = store.begin('Turn');
    gesture.preview(turn(store, 0, 1));
    store.undo();
    const after = store.scene.value;
    gesture.preview(turn(store, 0, 2));
    gesture.commit();
    expect(store.scene.value).toBe(after);
  });

  it('commits an open gesture before another begins', () => {
    const store = openStore();
    store.begin('first').preview(turn(store, 0, 1));
    store.dispatch(turn(store, 1, 1, 'second'));
    store.undo();
    expect(store.undoLabel.value).toBe('first');
  });

  it('takes a committed gesture back as if it had never been, unless something came after', () => {
    const store = openStore();
    const before = store.scene.value;
    const first = store.begin('Turn');
    first.preview(turn(store, 0, 1));
    first.commit();
    first.withdraw();
    expect(store.scene.value).toBe(before);
    expect([store.undoLabel.value, store.redoLabel.value]).toEqual([null, null]);
    first.withdraw();
    const second = store.begin('Turn');
    second.preview(turn(store, 0, 1));
    second.commit();
    store.dispatch(turn(store, 1, 1, 'after'));
    second.withdraw();
    expect(store.undoLabel.value).toBe('after');
  });

  it('goes back and forth through the very same scenes, whatever was amended between its steps', () => {
    const amend = (store: Store, clip: number): void => {
      store.amend(bindClip(selected(store).id, clip % 2 === 0 ? 0 : null));
    };
    const actions: readonly ((store: Store, number: number) => void)[] = [
      (store, number) => store.dispatch(turn(store, 0, number)),
      amend,
      amend,
      (store) => void store.undo(),
      (store) => void store.redo(),
    ];
    const walk = fc.array(fc.tuple(fc.nat(actions.length - 1), fc.nat(9)), { maxLength: 20 });
    fc.assert(
      fc.property(walk, (chosen) => {
        const store = openStore();
        for (const [action, number] of chosen) actions[action]!(store, number);
        const back: Scene[] = [store.scene.value];
        while (store.undo() !== null) back.push(store.scene.value);
        const forth: Scene[] = [store.scene.value];
        while (forth.length < back.length && store.redo() !== null) forth.push(store.scene.value);
        expect(forth.reverse().every((scene, i) => scene === back[i])).toBe(true);
      }),
    );
  });

  it('records nothing where nothing changed', () => {
    const store = openStore();
    store.begin('Turn').commit();
    expect(store.undoLabel.value).toBeNull();
  });

  it('takes an edit that changes nothing for no step, and keeps the very scene', () => {
    const store = openStore();
    const before = store.scene.value;
    const { id, q } = selected(store);
    store.dispatch(setPose(id, q));
    store.dispatch(setMethod(id, 'linear-blend'));
    const gesture = store.begin('There and back');
    gesture.preview(turn(store, 0, 1));
    gesture.preview(setPose(id, q));
    gesture.commit();
    expect(store.undoLabel.value).toBeNull();
    expect(store.scene.value).toBe(before);
  });

  it('forgets what was undone once something else is done', () => {
    const store = openStore();
    store.dispatch(turn(store, 0, 1, 'first'));
    store.undo();
    store.dispatch(turn(store, 0, 2, 'second'));
    expect(store.redoLabel.value).toBeNull();
  });

  it('takes a wrong caller for an error', () => {
    const store = openStore();
    const { id } = selected(store);
    expect(() => store.dispatch(turn(store, 1e6, 0))).toThrow(/contract/);
    expect(() => store.dispatch(setPose(id, new Float64Array(1)))).toThrow(/contract/);
  });
});
