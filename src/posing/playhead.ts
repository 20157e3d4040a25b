import type { Clip } from '../core/motion/clip.ts';

/**
 * What happens at the end of a clip's range: playback stops, starts again, reverses, or continues;
 * then each channel uses its own extrapolation.
 */
export type PlayMode = 'once' | 'loop' | 'ping-pong' | 'go on';

export interface Playhead {
  /** In seconds. */
  readonly time: number;
  /** False while ping-pong plays backwards. */
  readonly forward: boolean;
  readonly ended: boolean;
}

/** Returns the playhead after an interval of the clip's time, in seconds. */
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
 * Converts a time of the scene, in which several clips may play, to a time of a clip: within its
 * range, repeated, unless the play mode continues beyond the range.
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
