import type { Clip } from '../core/clip.ts';

/**
 * What playing does at the end of a clip's range: stops, begins again, turns back, or goes on, where
 * each channel has its own extrapolation.
 */
export type PlayMode = 'once' | 'loop' | 'ping-pong' | 'go on';

export interface Playhead {
  /** Seconds. */
  readonly time: number;
  /** False on the way back of a ping-pong. */
  readonly forward: boolean;
  readonly ended: boolean;
}

/** Where the playhead is after so many seconds of the clip. */
export function advance(
  { start, end }: Pick<Clip, 'start' | 'end'>,
  { time, forward }: Pick<Playhead, 'time' | 'forward'>,
  seconds: number,
  mode: PlayMode,
): Playhead {
  const duration = end - start;
  const moved = time + (forward ? seconds : -seconds);
  if (mode === 'go on') return { time: time + seconds, forward: true, ended: false };
  if (!(duration > 0)) return { time: start, forward: true, ended: mode === 'once' };
  if (mode === 'once') {
    return { time: Math.min(Math.max(moved, start), end), forward: true, ended: moved >= end };
  }
  const into = forward ? moved - start : 2 * duration - (moved - start);
  const cycle = mode === 'loop' ? duration : 2 * duration;
  const at = modulo(mode === 'loop' ? moved - start : into, cycle);
  const back = at > duration;
  return { time: start + (back ? cycle - at : at), forward: !back, ended: false };
}

/**
 * The time at which a clip is shown at a time of the scene, in which several play: within its range,
 * again and again, but where playing goes on past it.
 */
export function timeInClip(
  { start, end }: Pick<Clip, 'start' | 'end'>,
  time: number,
  mode: PlayMode,
): number {
  if (mode === 'go on' || (time >= start && time <= end)) return time;
  return end > start ? start + modulo(time - start, end - start) : start;
}

function modulo(value: number, divisor: number): number {
  return ((value % divisor) + divisor) % divisor;
}
