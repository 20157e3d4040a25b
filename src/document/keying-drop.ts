import { jointOfValue } from '../core/pose.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { animatedBy, rotationOf } from './animated.ts';
import type { Edit } from './edit.ts';
import type { KeyedThings } from './keying-targets.ts';
import { type Actor, boundClip, type Scene } from './scene.ts';

/**
 * Lets all actors show their clips again, without what was edited and not keyed. What no curve moves
 * stays as the character's own.
 */
export const dropUnkeyed: Edit = {
  label: 'Drop unkeyed values',
  apply: (scene) => ({
    ...scene,
    actors: scene.actors.map((actor) => (actor.unkeyed ? { ...actor, unkeyed: null } : actor)),
  }),
};

/** How many unkeyed values disappear if they are dropped, since curves move them. */
export function droppedCount({ actors }: Scene): number {
  return actors.reduce((sum, actor) => sum + droppedOf(actor), 0);
}

function droppedOf(actor: Actor): number {
  const [clip, { unkeyed, character }] = [boundClip(actor), actor];
  if (!clip || !unkeyed) return 0;
  const { values, morphs, pins } = animatedBy(clip, character);
  return thingCount(character.skeleton, {
    values: unkeyed.values.filter((at) => values.has(at)),
    morphs: unkeyed.morphs.filter((at) => morphs.has(at)),
    pins: unkeyed.pins.filter((at) => pins.has(at)),
  });
}

/** The number of values, the four of a ball counted as one. */
function thingCount(skeleton: Skeleton, { values, morphs, pins }: KeyedThings): number {
  const firsts = values.map((index) => {
    const turns = rotationOf(skeleton, jointOfValue(skeleton, index));
    const isBall = turns.length === 4 && turns.includes(index);
    return isBall ? turns[0]! : index;
  });
  return new Set(firsts).size + morphs.length + pins.length;
}
