import type { Character } from '../core/character.ts';
import type { MethodId } from '../skinning/method.ts';
import type { Edit } from './edit.ts';
import { type ActorLook, nextClay, plainLook } from './actor-look.ts';
import { type Actor, type ActorId, createActor, freeId, type KeptState } from './scene.ts';

/** The parts of an actor that is to be opened. */
export interface NewActor {
  readonly character: Character;
  readonly method: MethodId;
  readonly kept?: Omit<KeptState, 'look'>;
  /** What is known of its look; it gets the next clay unless this names one. */
  readonly look?: Partial<ActorLook>;
}

/**
 * Replaces actors by characters in their files' state, except for the values that are given.
 *
 * @param replaced the actors that are replaced; none, to add the characters beside all
 */
export function openCharacters(replaced: readonly ActorId[], opened: readonly NewActor[]): Edit {
  const names = opened.map(({ character }) => character.name);
  const name = names.length > 1 ? `${names.length} characters` : names.join('');
  return {
    label: `${replaced.length === 0 ? 'Add' : 'Open'} ${name}`,
    apply(scene) {
      const first = freeId(scene);
      const actors: Actor[] = scene.actors.filter(({ id }) => !replaced.includes(id));
      for (const [index, { character, method, kept, look }] of opened.entries()) {
        const clay = nextClay(actors.map((actor) => actor.look));
        const full = { ...kept, look: { ...plainLook, clay, ...look } };
        actors.push(createActor(first + index, character, method, full));
      }
      return { ...scene, actors };
    },
  };
}

export function openCharacter(
  replaced: ActorId | null,
  character: Character,
  method: MethodId,
  kept: KeptState = {},
): Edit {
  return openCharacters(replaced === null ? [] : [replaced], [
    { character, method, kept, ...(kept.look && { look: kept.look }) },
  ]);
}
