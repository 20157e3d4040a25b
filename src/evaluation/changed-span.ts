import type { ChannelParts, ClipParts } from '../core/motion/clip-parts.ts';
import { channelKey } from '../core/motion/targets.ts';
import { sameValue } from '../core/same-value.ts';

type Span = readonly [from: number, to: number];

const nothing: Span = [Infinity, -Infinity];
const everything: Span = [-Infinity, Infinity];

/** A key shapes the curve as far as this many keys away, by the slopes of its neighbors. */
const reach = 2;

/**
 * Returns the time between which the curves of two clips may differ, in seconds; the first is after
 * the second if they nowhere do.
 */
export function changedSpan(before: ClipParts, after: ClipParts): Span {
  if (before === after || before.channels === after.channels) return nothing;
  const [old, now] = [byKey(before), byKey(after)];
  let [from, to] = nothing;
  for (const key of new Set([...old.keys(), ...now.keys()])) {
    const span = changeOf(old.get(key), now.get(key));
    [from, to] = [Math.min(from, span[0]), Math.max(to, span[1])];
  }
  return [from, to];
}

function byKey({ channels }: ClipParts): Map<string, ChannelParts> {
  return new Map(
    channels.flatMap((each) => (each.target ? [[channelKey(each.target), each]] : [])),
  );
}

function changeOf(a: ChannelParts | undefined, b: ChannelParts | undefined): Span {
  if (a === b) return nothing;
  if (!a || !b || a.before !== b.before || a.after !== b.after) return everything;
  if (isRepeated(a) || !sameValue(a.target, b.target)) return everything;
  const isSame = (i: number, j: number): boolean => sameValue(a.keys[i], b.keys[j]);
  const shorter = Math.min(a.keys.length, b.keys.length);
  let first = 0;
  while (first < shorter && isSame(first, first)) first++;
  let last = 0;
  while (last < shorter - first && isSame(a.keys.length - 1 - last, b.keys.length - 1 - last))
    last++;
  if (first === a.keys.length && first === b.keys.length) return nothing;
  // The keys on both sides of the change are the same in both.
  const from = a.keys[first - reach]?.time ?? -Infinity;
  const to = a.keys[a.keys.length - last + reach - 1]?.time ?? Infinity;
  return last < reach ? [from, Infinity] : [from, to];
}

/** Whether what is between the keys shows outside of them too. */
function isRepeated({ before, after }: ChannelParts): boolean {
  return [before, after].some((rule) => rule !== 'constant' && rule !== 'linear');
}
