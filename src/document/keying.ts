import { clipFor, evaluateClip } from '../core/motion/clip.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import { setKey } from '../core/motion/edit/set-key.ts';
import { pinValues } from '../core/motion/targets.ts';
import type { Unkeyed } from '../posing/unkeyed.ts';
import { animatedBy } from './animated.ts';
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
  const held =
    actor.clip === clip ? actor.unkeyed : differing({ ...actor, ...shown }, reached, time);
  const unkeyed = held && without({ ...held, time }, done);
  return { ...actor, clips, clip, unkeyed };
}

function without({ time, ...held }: Unkeyed, done: KeyedThings): Unkeyed | null {
  const left = (kind: keyof KeyedThings): readonly number[] =>
    held[kind].filter((at) => !done[kind].includes(at));
  const [values, morphs, pins] = [left('values'), left('morphs'), left('pins')];
  if (values.length + morphs.length + pins.length === 0) return null;
  return { time, values, morphs, pins };
}

/** What a clip that was not bound would change of what is shown; it is held over the clip. */
function differing(
  { character, q, morphWeights, pins }: Pick<Actor, 'character' | keyof ShownState>,
  clip: ClipParts,
  time: number,
): Unkeyed {
  const clipped = {
    q: q.slice(),
    morphWeights: morphWeights.slice(),
    pins: new Float64Array(character.skeleton.jointCount * pinValues.length),
  };
  evaluateClip(clipFor(clip, character), time, clipped);
  const differs = (own: Float64Array, other: Float64Array) => (at: number) =>
    !Object.is(own[at], other[at]);
  const animated = animatedBy(clip, character);
  const pinned = pins.map(({ joint }) => joint);
  return {
    time,
    values: [...animated.values.keys()].filter(differs(q, clipped.q)).sort(increasing),
    morphs: [...animated.morphs.keys()]
      .filter(differs(morphWeights, clipped.morphWeights))
      .sort(increasing),
    pins: pinned.filter((joint) => animated.pins.has(joint)).sort(increasing),
  };
}

function increasing(a: number, b: number): number {
  return a - b;
}
