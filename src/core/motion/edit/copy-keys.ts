import type { ChannelParts, ClipParts } from '../clip-parts.ts';
import type { KeySelection } from '../key-selection.ts';
import { type ChannelKey, channelKey } from '../targets.ts';
import { changeChannel, channelOf, keyOf } from './channels.ts';
import { type AnyKey, isScalarKey, mergedKeys, withKeys } from './keys.ts';
import { type EditedKeys, indicesAt } from './selection.ts';
import { stretchedTangents } from './stretch.ts';

/** Copied keys, with what is needed to make their channels. */
export interface KeyClipboard {
  /** Of the first and of the last copied key, in seconds. */
  readonly start: number;
  readonly end: number;
  /** Channels that have the copied keys only; each has a target. */
  readonly channels: readonly ChannelParts[];
}

/** Copies the keys of a selection that exist. */
export function copyKeys(clip: ClipParts, selection: KeySelection): KeyClipboard {
  const channels = clip.channels.flatMap((channel) => {
    const times = selection.get(keyOf(channel) ?? '') ?? [];
    const keys = indicesAt(channel, times).map((index) => channel.keys[index]!);
    return keys.length > 0 ? withKeys(channel, keys) : [];
  });
  const times = channels.flatMap(({ keys }) => [keys[0]!.time, keys.at(-1)!.time]);
  return { start: Math.min(...times), end: Math.max(...times), channels };
}

/**
 * Pastes keys so that the first of them all is at a time. They replace keys at the same times; a
 * channel that the clip lacks is made.
 *
 * @param options.reversed from the last to the first, as the motion backward
 */
export function pasteKeys(
  clip: ClipParts,
  { channels, start, end }: KeyClipboard,
  time: number,
  { reversed = false }: { readonly reversed?: boolean } = {},
): EditedKeys {
  const selection = new Map<ChannelKey, readonly number[]>();
  let pasted = clip;
  const placed = (key: AnyKey): AnyKey => {
    if (!reversed) return { ...key, time: time + (key.time - start) };
    const backward = { ...key, time: time + (end - key.time) };
    return isScalarKey(backward)
      ? { ...backward, ...stretchedTangents(backward, -1, 1) }
      : backward;
  };
  for (const channel of channels) {
    const key = channelKey(channel.target!);
    const put = mergedKeys<AnyKey>([], channel.keys.map(placed));
    selection.set(
      key,
      put.map((each) => each.time),
    );
    pasted = channelOf(pasted, key)
      ? changeChannel(pasted, key, (own) => withKeys(own, mergedKeys<AnyKey>(own.keys, put)))
      : { ...pasted, channels: [...pasted.channels, withKeys(channel, put)] };
  }
  return { clip: pasted, selection };
}
