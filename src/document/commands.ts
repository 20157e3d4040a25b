import { assert } from '../core/assert.ts';
import type { Character } from '../core/character.ts';
import { jointRange } from '../core/pose.ts';
import type { MethodId } from '../skinning/method.ts';
import {
  type CharacterId,
  type CharacterState,
  characterState,
  type Document,
  type KeptState,
} from './document.ts';

/** An edit: a pure function from document to document, with a name for the Undo button. */
export interface Command {
  readonly label: string;
  apply(document: Document): Document;
}

/**
 * Sets one value of a character's pose. An edit is of what is shown: of a bound clip the pose of the
 * moment becomes the character's own, and the clip lets go.
 *
 * @param shown (qCount) the pose that is shown
 */
export function setValue(
  id: CharacterId,
  shown: Float64Array,
  index: number,
  value: number,
  label: string,
): Command {
  assert(index >= 0 && index < shown.length, 'an index of q');
  const q = shown.slice();
  q[index] = value;
  return setPose(id, q, label);
}

/** Puts a whole pose in the place of a character's. */
export function setPose(id: CharacterId, q: Float64Array, label = 'Set the pose'): Command {
  const own = q.slice();
  return editCharacter(id, label, (state) => {
    assert(own.length === state.q.length, 'a pose of the same skeleton');
    return { ...state, q: own, clip: null };
  });
}

/** Back to the file's pose and shape. */
export function resetPose(id: CharacterId): Command {
  return editCharacter(id, 'Reset the pose', (state) => ({
    ...state,
    q: state.character.skeleton.qRest.slice(),
    morphWeights: new Float64Array(state.morphWeights.length),
    clip: null,
  }));
}

/** One joint back to the file's pose; the others stay as they are shown. */
export function resetJoint(
  { id, character: { skeleton } }: CharacterState,
  shown: Float64Array,
  joint: number,
): Command {
  const [from, to] = jointRange(skeleton, joint);
  const q = shown.slice();
  q.set(skeleton.qRest.subarray(from, to), from);
  return setPose(id, q, `Reset ${skeleton.names[joint]!}`);
}

export function setMorphWeight(
  id: CharacterId,
  index: number,
  weight: number,
  label: string,
): Command {
  return editCharacter(id, label, (state) => {
    assert(index >= 0 && index < state.morphWeights.length, 'a morph of the character');
    const morphWeights = state.morphWeights.slice();
    morphWeights[index] = weight;
    return { ...state, morphWeights };
  });
}

/** Binds a clip, whose values are then shown over the pose; or none. */
export function bindClip(id: CharacterId, clip: number | null): Command {
  return editCharacter(id, clip === null ? 'Let the clip go' : 'Bind a clip', (state) => {
    assert(clip === null || clip < state.character.clips.length, 'a clip of the character');
    return { ...state, clip };
  });
}

export function setMethod(id: CharacterId, method: MethodId): Command {
  return editCharacter(id, 'Change the skinning method', (state) => ({ ...state, method }));
}

export function setNormalizeWeights(id: CharacterId, normalizeWeights: boolean): Command {
  const label = normalizeWeights ? 'Normalise weights' : 'Use weights as in the file';
  return editCharacter(id, label, (state) => ({ ...state, normalizeWeights }));
}

/** Puts a character in the place of the selected one, as its files have it but for what is given. */
export function openCharacter(character: Character, method: MethodId, kept?: KeptState): Command {
  return {
    label: `Open ${character.name}`,
    apply(document) {
      const { characters, selectedId } = document;
      const id = 1 + characters.reduce((largest, each) => Math.max(largest, each.id), 0);
      const opened = characterState(id, character, method, kept);
      const others = characters.filter((each) => each.id !== selectedId);
      return { ...document, characters: [...others, opened], selectedId: id };
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
