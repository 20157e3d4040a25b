import { timeInClip } from '../posing/playhead.ts';
import { type Actor, boundClip, type Scene } from './scene.ts';
import type { Session } from './session.ts';

type Timing = Pick<Session, 'clipTime' | 'playMode' | 'snapsToFrames' | 'clipIndex'>;

/** Where keys of a character go. */
export interface KeyPlace {
  /** The index of the clip, or that of a new one after the others. */
  readonly clip: number;
  /** In seconds of that clip. */
  readonly time: number;
}

/**
 * Returns where keys go now: into the bound clip, else the one that Play would bind, at the
 * playhead, at the nearest frame if times snap. In a scene that no clip moves, a new clip begins
 * with its first key.
 *
 * @param selected the id of the selected actor, whose last choice of a clip the session knows
 */
export function keyPlace(
  { actors }: Scene,
  session: Timing,
  actor: Actor,
  selected: number | null,
): KeyPlace {
  const { clipTime, playMode } = session;
  const chosen = actor.id === selected ? session.clipIndex.peek() : 0;
  const clip = actor.clip ?? (actor.clips[chosen] ? chosen : 0);
  const parts = actor.clips[clip];
  const bound = boundClip(actor);
  const isMoved = actors.some((other) => other.clip !== null);
  if (!parts && !isMoved) return { clip, time: 0 };
  const time = bound ? timeInClip(bound, clipTime.peek(), playMode.peek()) : clipTime.peek();
  return { clip, time: snapped(session, time, parts?.fps ?? 30) };
}

/** The nearest frame, if times snap to frames. */
export function snapped(
  { snapsToFrames }: Pick<Session, 'snapsToFrames'>,
  time: number,
  fps: number,
): number {
  return snapsToFrames.peek() ? Math.round(time * fps) / fps : time;
}
