import type { ChannelParts, ClipParts } from '../clip-parts.ts';
import type { KeySelection } from '../key-selection.ts';
import type { ChannelKey } from '../targets.ts';
import { keyOf } from './channels.ts';
import { firstFrom, keyAt, sameTime } from './keys.ts';

export interface SelectedKey {
  readonly channelKey: ChannelKey;
  readonly channel: ChannelParts;
  /** Of the key in the channel's keys. */
  readonly index: number;
}

/** An edited clip, and its keys that were edited. */
export interface EditedKeys {
  readonly clip: ClipParts;
  readonly selection: KeySelection;
}

/** Returns what exists of a selection, in the order of the clip's channels, by time. */
export function selectedIn(clip: ClipParts, selection: KeySelection): readonly SelectedKey[] {
  return clip.channels.flatMap((channel) => {
    const channelKey = keyOf(channel);
    const times = channelKey === null ? undefined : selection.get(channelKey);
    if (channelKey === null || !times) return [];
    return indicesAt(channel, times).map((index) => ({ channelKey, channel, index }));
  });
}

/** The indices of a channel's keys that are at some times, increasing. */
export function indicesAt({ keys }: ChannelParts, times: readonly number[]): readonly number[] {
  const found: number[] = [];
  let isIncreasing = true;
  for (const time of times) {
    const last = found.at(-1) ?? -1;
    // Where all keys are selected, the next one is the key that follows.
    const index = keys[last + 1]?.time === time ? last + 1 : keyAt(keys, time);
    if (index < 0) continue;
    isIncreasing &&= index > last;
    found.push(index);
  }
  return isIncreasing ? found : [...new Set(found)].sort((a, b) => a - b);
}

/** Selects the keys of some channels that are within two times, ends included, in either order. */
export function keysWithin(
  clip: ClipParts,
  keys: Iterable<ChannelKey>,
  [one, other]: readonly [number, number],
): KeySelection {
  const [start, end] = [Math.min(one, other), Math.max(one, other)];
  const channels = new Set<ChannelKey | null>(keys);
  const found = new Map<ChannelKey, readonly number[]>();
  for (const channel of clip.channels) {
    const key = keyOf(channel);
    if (key === null || !channels.has(key)) continue;
    const { keys: all } = channel;
    const times: number[] = [];
    for (let at = firstFrom(all, start); at < all.length && all[at]!.time <= end; at++) {
      times.push(all[at]!.time);
    }
    addTimes(found, key, times);
  }
  return found;
}

/** The keys of both selections. */
export function united(a: KeySelection, b: KeySelection): KeySelection {
  return combined(a, b, (first, second) => [...first, ...without(second, first)]);
}

/** The keys of one selection only: those of `b` are added, or taken away if `a` has them. */
export function toggled(a: KeySelection, b: KeySelection): KeySelection {
  return combined(a, b, (first, second) => [...without(first, second), ...without(second, first)]);
}

function combined(
  a: KeySelection,
  b: KeySelection,
  combine: (first: readonly number[], second: readonly number[]) => number[],
): KeySelection {
  const all = new Map<ChannelKey, readonly number[]>();
  for (const key of new Set([...a.keys(), ...b.keys()])) {
    const times = combine(a.get(key) ?? [], b.get(key) ?? []);
    addTimes(
      all,
      key,
      times.sort((one, other) => one - other),
    );
  }
  return all;
}

function without(times: readonly number[], others: readonly number[]): readonly number[] {
  return times.filter((time) => !others.some((other) => sameTime(time, other)));
}

/** A channel of which nothing is selected is absent. */
function addTimes(
  selection: Map<ChannelKey, readonly number[]>,
  key: ChannelKey,
  times: readonly number[],
): void {
  if (times.length > 0) selection.set(key, times);
}
