import type { RotationChannelParts } from '../clip-parts.ts';
import { turnAngle } from '../quaternions.ts';
import { evaluateRotation, rotationChannelFor } from '../rotation-channel.ts';
import { rotationWith } from './insert-key.ts';
import { firstFrom, keyAt } from './keys.ts';

/** Into how many pieces each span is divided to find the piece with the largest turn. */
const pieces = 128;

/** By how many steps the largest turn is narrowed down within its piece. */
const narrowings = 30;

/**
 * The largest angle in radians, over the times of the keys, between a squad curve as it is and with
 * a key on it inserted; 0 for a slerp, which does not change, and where no key can be inserted
 * between others. A key changes the control points of its two neighbors, and so four spans.
 */
export function squadTurnOnInsert(channel: RotationChannelParts, time: number): number {
  const { keys } = channel;
  const isInside = keys.length > 1 && time > keys[0]!.time && time < keys.at(-1)!.time;
  if (channel.target.curve === 'slerp' || !isInside || keyAt(keys, time) >= 0) return 0;
  const changed = rotationWith(channel, time);
  const [before, after] = [rotationChannelFor(channel), rotationChannelFor(changed)];
  const [a, b] = [new Float64Array(4), new Float64Array(4)];
  const turnAt = (moment: number): number => {
    evaluateRotation(before, moment, a);
    evaluateRotation(after, moment, b);
    return turnAngle(a, b);
  };
  const at = firstFrom(keys, time);
  const ends = changed.keys.slice(Math.max(0, at - 2), at + 3).map((key) => key.time);
  const turns = ends.slice(1).map((end, span) => largestIn(turnAt, ends[span]!, end));
  return Math.max(...turns);
}

/** The largest value of a smooth function between two times: the best of many, then narrowed down. */
function largestIn(valueAt: (time: number) => number, start: number, end: number): number {
  let [best, largest] = [start, 0];
  const piece = (end - start) / pieces;
  for (let i = 0; i <= pieces; i++) {
    const value = valueAt(start + i * piece);
    if (value > largest) [best, largest] = [start + i * piece, value];
  }
  let [low, high] = [Math.max(start, best - piece), Math.min(end, best + piece)];
  for (let i = 0; i < narrowings; i++) {
    const third = (high - low) / 3;
    if (valueAt(low + third) < valueAt(high - third)) low += third;
    else high -= third;
  }
  return Math.max(largest, valueAt((low + high) / 2));
}
