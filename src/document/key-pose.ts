import { animatedBy } from './animated.ts';
import { type Edit, editActor } from './edit.ts';
import { keyedActor } from './keying.ts';
import type { ShownState } from './keying-targets.ts';
import { type Actor, boundClip } from './scene.ts';

/** A pose at a time of a clip, as it was and as it is to be. */
export interface MovedPose {
  /** In seconds of the bound clip. */
  readonly time: number;
  readonly before: ShownState;
  /** (qCount) */
  readonly q: Float64Array;
  /**
   * The nearest times on both sides, in seconds, at which the pose is to stay although nothing moved
   * it there so far.
   */
  readonly around: readonly number[];
}

/** Keys what differs of a pose at a time of the bound clip. */
export function keyMovedPose({ id }: Actor, moved: MovedPose, label: string): Edit {
  return editActor(id, label, (actor) => movedActor(actor, moved));
}

function movedActor(actor: Actor, { time, before, q, around }: MovedPose): Actor {
  const clip = boundClip(actor);
  if (!clip || actor.clip === null) return actor;
  const values = [...q.keys()].filter((at) => !Object.is(q[at], before.q[at]));
  if (values.length === 0) return actor;
  const animated = animatedBy(clip, actor.character).values;
  const held = { values: values.filter((at) => !animated.has(at)), morphs: [], pins: [] };
  // One key alone would move the pose at all times.
  const anchored =
    held.values.length === 0
      ? actor
      : around.reduce((made, at) => keyedActor(made, actor.clip!, at, before, held), actor);
  const what = { values, morphs: [], pins: [] };
  return keyedActor(anchored, actor.clip, time, { ...before, q }, what);
}
