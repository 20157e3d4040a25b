import { setKey } from '../core/motion/edit/set-key.ts';
import type { Unkeyed } from '../posing/unkeyed.ts';
import { emptyClip } from './clip-edits.ts';
import { type Edit, editActor } from './edit.ts';
import { type KeyedThings, keysOf, type ShownState } from './keying-targets.ts';
import type { Actor } from './scene.ts';

/**
 * Sets keys of values as they are shown. What is keyed is no longer unkeyed. The clip is bound, and
 * made if the character does not have it; a key outside its range lengthens it.
 *
 * @param clip the index of the clip, or that of a new one after the others
 * @param time of the keys, in seconds
 */
export function keyValues(
  { id }: Actor,
  clip: number,
  time: number,
  shown: ShownState,
  what: KeyedThings,
  label: string,
): Edit {
  return editActor(id, label, (actor) => keyedActor(actor, clip, time, shown, what));
}

/** See `keyValues`. */
export function keyedActor(
  actor: Actor,
  clip: number,
  time: number,
  shown: ShownState,
  what: KeyedThings,
): Actor {
  const { character } = actor;
  const before = actor.clips[clip] ?? emptyClip(actor.clips);
  const keys = keysOf(character.skeleton, before, shown, what);
  const keyed = keys.reduce((made, { target, value }) => setKey(made, target, time, value), before);
  const reached = {
    ...keyed,
    start: Math.min(keyed.start, time),
    end: Math.max(keyed.end, time),
  };
  const clips =
    clip < actor.clips.length ? actor.clips.with(clip, reached) : [...actor.clips, reached];
  const done = { ...what, values: [...what.values, ...keys.flatMap(({ indices }) => indices)] };
  const unkeyed = actor.unkeyed && without({ ...actor.unkeyed, time }, done);
  return { ...actor, clips, clip, unkeyed };
}

function without({ time, ...held }: Unkeyed, done: KeyedThings): Unkeyed | null {
  const left = (kind: keyof KeyedThings): readonly number[] =>
    held[kind].filter((at) => !done[kind].includes(at));
  const [values, morphs, pins] = [left('values'), left('morphs'), left('pins')];
  if (values.length + morphs.length + pins.length === 0) return null;
  return { time, values, morphs, pins };
}
