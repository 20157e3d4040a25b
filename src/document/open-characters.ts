import type { Character } from '../core/character.ts';
import type { MethodId } from '../skinning/method.ts';
import type { Edit } from './edits.ts';
import { type ActorId, createActor, freeId, type KeptState } from './scene.ts';

/** The parts of an actor that is to be opened. */
export interface NewActor {
  readonly character: Character;
  readonly method: MethodId;
  readonly kept?: KeptState;
}

/**
 * Replaces an actor by characters in their files' state, except for the values that are given.
 *
 * @param replaced the actor that is replaced; null adds the characters
 */
export function openCharacters(replaced: ActorId | null, opened: readonly NewActor[]): Edit {
  const names = opened.map(({ character }) => character.name);
  const name = names.length > 1 ? `${names.length} characters` : names.join('');
  return {
    label: `${replaced === null ? 'Add' : 'Open'} ${name}`,
    apply(scene) {
      const first = freeId(scene);
      const actors = opened.map(({ character, method, kept }, index) =>
        createActor(first + index, character, method, kept),
      );
      return { ...scene, actors: [...scene.actors.filter(({ id }) => id !== replaced), ...actors] };
    },
  };
}

export function openCharacter(
  replaced: ActorId | null,
  character: Character,
  method: MethodId,
  kept?: KeptState,
): Edit {
  return openCharacters(replaced, [{ character, method, ...(kept && { kept }) }]);
}
