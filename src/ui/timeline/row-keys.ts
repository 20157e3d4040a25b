import { channelFor, isStepped } from '../../core/motion/channel.ts';
import {
  type ChannelParts,
  isRotationChannel,
  type ScalarChannelParts,
} from '../../core/motion/clip-parts.ts';
import { type AnyKey, sameTime } from '../../core/motion/edit/keys.ts';
import { sameValue } from '../../core/same-value.ts';

/** The merged keys of a row. */
export interface RowKeys {
  /** (keyCount) in seconds, increasing; keys of several channels at one time are one. */
  readonly times: Float64Array;
  /** (keyCount) 1 where nothing moves from a key until the next one. */
  readonly isHeld: Uint8Array;
}

/** Merges the keys of some channels; done once for each list of them. */
export function keysOfRow(channels: readonly ChannelParts[]): RowKeys {
  let keys = merged.get(channels);
  if (!keys) merged.set(channels, (keys = mergeKeys(channels.map(keysOfChannel))));
  return keys;
}

const merged = new WeakMap<readonly ChannelParts[], RowKeys>();
const single = new WeakMap<ChannelParts, RowKeys>();

function keysOfChannel(channel: ChannelParts): RowKeys {
  let keys = single.get(channel);
  if (!keys) {
    const all: readonly AnyKey[] = channel.keys;
    const times = Float64Array.from(all, ({ time }) => time);
    const isHeld = heldKeys(channel);
    single.set(channel, (keys = { times, isHeld }));
  }
  return keys;
}

/** Marks the keys from which a channel does not move until the next one. */
function heldKeys(channel: ChannelParts): Uint8Array {
  const isHeld = new Uint8Array(channel.keys.length);
  const isRotation = isRotationChannel(channel);
  for (let at = 0; at + 1 < isHeld.length; at++) {
    if (!sameValue(channel.keys[at]!.value, channel.keys[at + 1]!.value)) continue;
    isHeld[at] = Number(isRotation || isFlat(channel, at));
  }
  return isHeld;
}

/** Whether a curve between two equal values is level. */
function isFlat(channel: ScalarChannelParts, at: number): boolean {
  const { slopesIn, slopesOut } = channelFor(channel);
  return isStepped(channel.keys, at) || (slopesOut[at] === 0 && slopesIn[at + 1] === 0);
}

function mergeKeys(rows: readonly RowKeys[]): RowKeys {
  if (rows.length === 1) return rows[0]!;
  const times = mergeTimes(rows.map((row) => row.times));
  /** How many channels begin, less how many end, to move, and to have a span, at each time. */
  const [moving, covering] = [new Int32Array(times.length), new Int32Array(times.length)];
  for (const row of rows) {
    let from = 0;
    for (let key = 0; key + 1 < row.times.length; key++) {
      while (times[from]! < row.times[key]! && !sameTime(times[from]!, row.times[key]!)) from++;
      let to = from;
      while (times[to]! < row.times[key + 1]! && !sameTime(times[to]!, row.times[key + 1]!)) to++;
      const counted = row.isHeld[key] === 1 ? covering : moving;
      counted[from]! += 1;
      counted[to]! -= 1;
      from = to;
    }
  }
  const isHeld = new Uint8Array(times.length);
  let [moves, covers] = [0, 0];
  for (let at = 0; at < times.length; at++) {
    moves += moving[at]!;
    covers += covering[at]!;
    isHeld[at] = Number(covers > 0 && moves === 0);
  }
  return { times, isHeld };
}

/** Merges lists of increasing times; times of one key are taken once. */
export function mergeTimes(lists: readonly Float64Array[]): Float64Array {
  return lists.reduce(mergeTwo, new Float64Array(0));
}

function mergeTwo(a: Float64Array, b: Float64Array): Float64Array {
  if (a.length === 0) return b;
  const all = new Float64Array(a.length + b.length);
  let [count, i, j] = [0, 0, 0];
  while (i < a.length || j < b.length) {
    const isFirst = j >= b.length || (i < a.length && a[i]! <= b[j]!);
    const time = isFirst ? a[i++]! : b[j++]!;
    if (count === 0 || !sameTime(all[count - 1]!, time)) all[count++] = time;
  }
  // Most channels of a clip have their keys at the same times.
  return count === a.length ? a : all.slice(0, count);
}

/** The index of the first time that is not below another one. */
export function firstAtOrAfter(times: Float64Array, time: number): number {
  let [first, end] = [0, times.length];
  while (first < end) {
    const middle = (first + end) >> 1;
    if (times[middle]! < time) first = middle + 1;
    else end = middle;
  }
  return first;
}

/** The index of the time that is nearest to another one and not further than a reach, or -1. */
export function nearestKey(times: Float64Array, time: number, reach: number): number {
  const above = firstAtOrAfter(times, time);
  const distance = (at: number): number => Math.abs((times[at] ?? Infinity) - time);
  const nearest = distance(above - 1) < distance(above) ? above - 1 : above;
  return distance(nearest) <= reach ? nearest : -1;
}
