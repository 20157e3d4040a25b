import type { ClipParts } from '../core/motion/clip-parts.ts';
import type { GhostSettings } from '../document/motion-view.ts';
import type { PlayMode } from '../posing/playhead.ts';

/** A moment at which a ghost stands. */
export interface GhostTime {
  /** In seconds of the clip. */
  readonly time: number;
  /** 1 for the nearest to the present, -1 for the nearest before it, and so on. */
  readonly rank: number;
}

/** Keys that are so near to the present, in seconds, are those of the present. */
const present = 1e-4;

/**
 * Returns the moments of ghosts, the farthest first. None are outside the clip's range, unless the
 * clip goes on there.
 *
 * @param time the present, in seconds of the clip
 */
export function ghostTimes(
  clip: ClipParts,
  time: number,
  settings: GhostSettings,
  mode: PlayMode,
): readonly GhostTime[] {
  const { before, after, at } = settings;
  const moments =
    at === 'keys' ? keysAround(clip, time, before, after) : framesAround(clip, time, settings);
  const goesOn = at === 'frames' && (mode === 'loop' || mode === 'go on');
  return moments
    .filter((moment) => goesOn || (moment.time >= clip.start && moment.time <= clip.end))
    .sort((a, b) => Math.abs(b.rank) - Math.abs(a.rank));
}

function framesAround(
  { fps }: ClipParts,
  time: number,
  { before, after, frames }: GhostSettings,
): GhostTime[] {
  const ranks = Array.from({ length: before + after + 1 }, (_, at) => at - before);
  return ranks
    .filter((rank) => rank !== 0)
    .map((rank) => ({ rank, time: time + (rank * frames) / fps }));
}

function keysAround(clip: ClipParts, time: number, before: number, after: number): GhostTime[] {
  const times = keyTimes(clip.channels);
  const earlier = times.filter((each) => each < time - present).toReversed();
  const later = times.filter((each) => each > time + present);
  return [
    ...earlier.slice(0, before).map((each, at) => ({ time: each, rank: -1 - at })),
    ...later.slice(0, after).map((each, at) => ({ time: each, rank: at + 1 })),
  ];
}

/** The times of the keys of channels, each once, increasing, in seconds. */
export function keyTimes(channels: ClipParts['channels']): readonly number[] {
  const all = channels.flatMap(({ keys }) => keys.map(({ time }) => time)).sort((a, b) => a - b);
  return all.filter((time, at) => at === 0 || time - all[at - 1]! > present);
}
