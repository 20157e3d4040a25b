import { keyAt } from '../core/motion/edit/keys.ts';
import { animatedBy } from '../document/animated.ts';
import { type Actor, boundClip } from '../document/scene.ts';
import { timeInClip } from '../posing/playhead.ts';
import type { Looking } from './editor.ts';

/**
 * What a clip has to do with a value: it was edited over the clip, it has a key at the playhead, a
 * curve moves it, or nothing.
 */
export type KeyedState = 'unkeyed' | 'keyed' | 'animated' | 'still';

/** A value by its kind: an index of q, an index of a morph, or a pinned joint. */
export type KeyedKind = 'values' | 'morphs' | 'pins';

/** The word for those who do not see its mark; empty if there is none. */
export const keyedText: Readonly<Record<KeyedState, string>> = {
  unkeyed: 'unkeyed',
  keyed: 'has a key here',
  animated: 'moved by the clip',
  still: '',
};

/** Returns what the bound clip of an actor has to do with one of its values. */
export function keyedState(
  { session }: Pick<Looking, 'session'>,
  actor: Actor | undefined,
  kind: KeyedKind,
  index: number,
): KeyedState {
  const clip = actor && boundClip(actor);
  if (!clip) return 'still';
  if (actor.unkeyed?.[kind].includes(index)) return 'unkeyed';
  const channels = animatedBy(clip, actor.character)[kind].get(index);
  if (!channels) return 'still';
  const time = timeInClip(clip, session.clipTime.value, session.playMode.value);
  const isKeyed = channels.some(({ keys }) => keyAt(keys, time) >= 0);
  return isKeyed ? 'keyed' : 'animated';
}
