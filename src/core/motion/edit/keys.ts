import type { ChannelParts, KeyParts, RotationKeyParts } from '../clip-parts.ts';

export type AnyKey = KeyParts | RotationKeyParts;

/** Keys of one channel are at least so many seconds apart. */
export const keyGap = 1e-4;

/** Whether two times, in seconds, are those of one key. */
export function sameTime(a: number, b: number): boolean {
  return Math.abs(a - b) < keyGap;
}

/** The index of the key at a time, or -1; keys are at increasing times. */
export function keyAt(keys: readonly { readonly time: number }[], time: number): number {
  const above = firstFrom(keys, time);
  const distance = (at: number): number => Math.abs((keys[at]?.time ?? Infinity) - time);
  const nearest = distance(above - 1) <= distance(above) ? above - 1 : above;
  return keys[nearest] && sameTime(keys[nearest].time, time) ? nearest : -1;
}

/** The index of the first key at a time or after it; the count of keys if there is none. */
export function firstFrom(keys: readonly { readonly time: number }[], time: number): number {
  let [first, end] = [0, keys.length];
  while (first < end) {
    const middle = (first + end) >> 1;
    if (keys[middle]!.time < time) first = middle + 1;
    else end = middle;
  }
  return first;
}

/**
 * Puts keys among others and returns all at increasing times. A key that is put replaces those at
 * its time; of several that are put at one time, the last one stays.
 *
 * @param kept at increasing times
 * @param put in any order
 */
export function mergedKeys<Key extends AnyKey>(
  kept: readonly Key[],
  put: readonly Key[],
): readonly Key[] {
  const placed: Key[] = [];
  for (const key of put.toSorted((a, b) => a.time - b.time)) {
    const former = placed.at(-1);
    if (former && sameTime(former.time, key.time)) placed.pop();
    placed.push(key);
  }
  const merged: Key[] = [];
  let next = 0;
  for (const key of kept) {
    while (next < placed.length && placed[next]!.time < key.time) merged.push(placed[next++]!);
    const [before, after] = [placed[next - 1], placed[next]];
    const isReplaced =
      (before && sameTime(before.time, key.time)) || (after && sameTime(after.time, key.time));
    if (!isReplaced) merged.push(key);
  }
  return [...merged, ...placed.slice(next)];
}

/** The channel with other keys, which are of its own kind. */
export function withKeys(channel: ChannelParts, keys: readonly AnyKey[]): ChannelParts {
  return { ...channel, keys } as ChannelParts;
}

export function isScalarKey(key: AnyKey): key is KeyParts {
  return typeof key.value === 'number';
}
