import { defaultFps } from '../core/motion/clip-parts.ts';
import { timeInClip } from '../posing/playhead.ts';
import { type Actor, boundClip, type Scene } from './scene.ts';
import type { Session } from './session.ts';

type Timing = Pick<Session, 'clipTime' | 'playMode' | 'snapsToFrames'>;

/** Where keys of a character go. */
export interface KeyPlace {
  /** The index of the clip, or that of a new one after the others. */
  readonly clip: number;
  /** In seconds of that clip. */
  readonly time: number;
}

/**
 * Returns where keys go now: into the bound clip, at the playhead, at the nearest frame if times
 * snap; else into a new one, since a pose without a clip belongs to none of the others. In a scene
 * that no clip moves, a new clip begins with its first key.
 */
export function keyPlace({ actors }: Scene, session: Timing, actor: Actor): KeyPlace {
  const { clipTime, playMode } = session;
  const bound = boundClip(actor);
  const clip = actor.clip ?? actor.clips.length;
  if (!bound && actors.every((other) => other.clip === null)) return { clip, time: 0 };
  const time = bound ? timeInClip(bound, clipTime.peek(), playMode.peek()) : clipTime.peek();
  return { clip, time: snapped(session, time, bound?.fps ?? defaultFps) };
}

/** The nearest frame, if times snap to frames. */
export function snapped(
  { snapsToFrames }: Pick<Session, 'snapsToFrames'>,
  time: number,
  fps: number,
): number {
  return snapsToFrames.peek() ? Math.round(time * fps) / fps : time;
}
