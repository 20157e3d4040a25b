import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  type Command,
  openCharacter,
  resetJoint,
  resetPose,
  setMethod,
  setNormalizeWeights,
  setPose,
  setValue,
} from '../../src/document/commands.ts';
import {
  type CharacterState,
  type Document,
  selectedCharacter,
} from '../../src/document/document.ts';
import { Store } from '../../src/document/store.ts';
import { methods } from '../../src/skinning/registry.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';

const characters = Object.values(allRigs).map((rig) => characterOfRig(rig()));

function openStore(): Store {
  const store = new Store();
  store.dispatch(openCharacter(characters[0]!, 'linear-blend'));
  return store;
}

function selected(store: Store): CharacterState {
  return selectedCharacter(store.document.value)!;
}

/** Everything that a document holds, to the bit: floats as hexadecimal bytes. */
function bits({ characters: states, selectedId }: Document): string {
  const parts = states.map(({ id, character, q, method, normalizeWeights }) => [
    id,
    characters.indexOf(character),
    Buffer.from(q.buffer, q.byteOffset, q.byteLength).toString('hex'),
    method,
    normalizeWeights,
  ]);
  return JSON.stringify([selectedId, parts]);
}

/** A command of any kind for the character that is selected. */
function commandOf(store: Store, kind: number, amount: number): Command {
  const { id, q, character } = selected(store);
  const index = Math.abs(Math.trunc(amount * 1e6)) % q.length;
  const joint = index % character.skeleton.jointCount;
  const kinds: (() => Command)[] = [
    () => setValue(id, index, amount, 'turn'),
    () =>
      setPose(
        id,
        q.map((value) => value + amount),
      ),
    () => resetPose(id),
    () => resetJoint(id, joint, 'joint'),
    () => setMethod(id, methods[index % methods.length]!.id),
    () => setNormalizeWeights(id, amount > 0),
    () => openCharacter(characters[index % characters.length]!, 'rigid'),
  ];
  return kinds[kind % kinds.length]!();
}

const step = fc.tuple(fc.nat(100), fc.double({ noNaN: true, min: -10, max: 10 }));

describe('the store', () => {
  it('undoes and redoes any run of commands to the bit', () => {
    fc.assert(
      fc.property(fc.array(step, { maxLength: 40 }), (steps) => {
        const store = openStore();
        const seen = [bits(store.document.value)];
        for (const [kind, amount] of steps) {
          store.dispatch(commandOf(store, kind, amount));
          seen.push(bits(store.document.value));
        }
        for (const expected of seen.slice(0, -1).reverse()) {
          store.undo();
          expect(bits(store.document.value)).toBe(expected);
        }
        for (const expected of seen.slice(1)) {
          store.redo();
          expect(bits(store.document.value)).toBe(expected);
        }
      }),
    );
  });

  it('keeps the first character: an empty page is nothing to go back to', () => {
    const store = openStore();
    expect(store.undoLabel.value).toBeNull();
    store.undo();
    expect(selected(store).character).toBe(characters[0]);
  });

  it('makes one entry of a gesture, however many previews it has', () => {
    const store = openStore();
    const { id } = selected(store);
    const before = bits(store.document.value);
    const gesture = store.begin('Turn elbow X');
    for (let i = 1; i <= 20; i++) gesture.preview(setValue(id, 0, i / 10, 'turn'));
    gesture.commit();
    expect(selected(store).q[0]).toBe(2);
    expect(store.undoLabel.value).toBe('Turn elbow X');
    store.undo();
    expect(bits(store.document.value)).toBe(before);
    expect(store.undoLabel.value).toBeNull();
    expect(store.redoLabel.value).toBe('Turn elbow X');
  });

  it('restores the exact bits when a gesture is cancelled, and records nothing', () => {
    const store = openStore();
    const before = store.document.value;
    const gesture = store.begin('Turn');
    gesture.preview(setValue(selected(store).id, 0, Math.PI / 7, 'turn'));
    expect(store.cancelGesture()).toBe(true);
    expect(store.document.value).toBe(before);
    expect(store.undoLabel.value).toBeNull();
    expect(gesture.isOpen).toBe(false);
  });

  it('ignores previews of a gesture that an undo has ended', () => {
    const store = openStore();
    const gesture = store.begin('Turn');
    gesture.preview(setValue(selected(store).id, 0, 1, 'turn'));
    store.undo();
    const after = store.document.value;
    gesture.preview(setValue(selected(store).id, 0, 2, 'turn'));
    gesture.commit();
    expect(store.document.value).toBe(after);
  });

  it('commits an open gesture before another begins', () => {
    const store = openStore();
    const { id } = selected(store);
    store.begin('first').preview(setValue(id, 0, 1, 'turn'));
    store.dispatch(setValue(id, 1, 1, 'second'));
    store.undo();
    expect(store.undoLabel.value).toBe('first');
  });

  it('records nothing where nothing changed', () => {
    const store = openStore();
    store.begin('Turn').commit();
    expect(store.undoLabel.value).toBeNull();
  });

  it('forgets what was undone once something else is done', () => {
    const store = openStore();
    const { id } = selected(store);
    store.dispatch(setValue(id, 0, 1, 'first'));
    store.undo();
    store.dispatch(setValue(id, 0, 2, 'second'));
    expect(store.redoLabel.value).toBeNull();
  });

  it('takes a wrong caller for an error', () => {
    const store = openStore();
    const { id } = selected(store);
    expect(() => store.dispatch(setValue(id, 1e6, 0, 'turn'))).toThrow(/contract/);
    expect(() => store.dispatch(setPose(id, new Float64Array(1)))).toThrow(/contract/);
  });
});
