import { assert } from '../core/assert.ts';
import type { Character } from '../core/character.ts';
import { jointRange } from '../core/pose.ts';
import type { MethodId } from '../skinning/method.ts';
import type { CharacterId, CharacterState, Document } from './document.ts';

/** An edit: a pure function from document to document, with a name for the Undo button. */
export interface Command {
  readonly label: string;
  apply(document: Document): Document;
}

/** Sets one value of a character's pose. */
export function setValue(id: CharacterId, index: number, value: number, label: string): Command {
  return editCharacter(id, label, (state) => {
    assert(index >= 0 && index < state.q.length, 'an index of q');
    const q = state.q.slice();
    q[index] = value;
    return { ...state, q };
  });
}

/** Puts a whole pose in the place of a character's. */
export function setPose(id: CharacterId, q: Float64Array, label = 'Set the pose'): Command {
  return editCharacter(id, label, (state) => {
    assert(q.length === state.q.length, 'a pose of the same skeleton');
    return { ...state, q: q.slice() };
  });
}

/** Back to the file's pose. */
export function resetPose(id: CharacterId): Command {
  return editCharacter(id, 'Reset the pose', (state) => ({
    ...state,
    q: state.character.skeleton.qRest.slice(),
  }));
}

/** One joint back to the file's pose. */
export function resetJoint(id: CharacterId, joint: number, name: string): Command {
  return editCharacter(id, `Reset ${name}`, (state) => {
    const { skeleton } = state.character;
    const [from, to] = jointRange(skeleton, joint);
    const q = state.q.slice();
    q.set(skeleton.qRest.subarray(from, to), from);
    return { ...state, q };
  });
}

export function setMethod(id: CharacterId, method: MethodId): Command {
  return editCharacter(id, 'Change the skinning method', (state) => ({ ...state, method }));
}

export function setNormalizeWeights(id: CharacterId, normalizeWeights: boolean): Command {
  const label = normalizeWeights ? 'Normalise weights' : 'Use weights as in the file';
  return editCharacter(id, label, (state) => ({ ...state, normalizeWeights }));
}

/** Puts a character in the place of the selected one, at the given pose or the file's. */
export function openCharacter(character: Character, method: MethodId, q?: Float64Array): Command {
  return {
    label: `Open ${character.name}`,
    apply(document) {
      const { characters, selectedId } = document;
      const id = 1 + characters.reduce((largest, each) => Math.max(largest, each.id), 0);
      const opened: CharacterState = {
        id,
        character,
        q: (q ?? character.skeleton.qRest).slice(),
        method,
        normalizeWeights: false,
      };
      const kept = characters.filter((each) => each.id !== selectedId);
      return { ...document, characters: [...kept, opened], selectedId: id };
    },
  };
}

function editCharacter(
  id: CharacterId,
  label: string,
  edit: (state: CharacterState) => CharacterState,
): Command {
  return {
    label,
    apply: (document) => ({
      ...document,
      characters: document.characters.map((state) => (state.id === id ? edit(state) : state)),
    }),
  };
}
