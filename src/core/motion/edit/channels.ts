import type { ChannelParts, ClipParts } from '../clip-parts.ts';
import { type ChannelKey, channelKey } from '../targets.ts';

/** The channel of a clip, or null if it has none with the key. */
export function channelOf(clip: ClipParts, key: ChannelKey): ChannelParts | null {
  return clip.channels.find((each) => keyOf(each) === key) ?? null;
}

/** The key of a channel, or null if its character does not have what it moves. */
export function keyOf({ target }: ChannelParts): ChannelKey | null {
  return target && channelKey(target);
}

/** Returns the clip without some channels. */
export function removeChannels(clip: ClipParts, keys: Iterable<ChannelKey>): ClipParts {
  const removed = new Set<ChannelKey | null>(keys);
  return withChannels(
    clip,
    clip.channels.filter((each) => !removed.has(keyOf(each))),
  );
}

/**
 * Changes some channels; the others stay the same objects, so that they are not compiled again.
 *
 * @param change returns the channel that takes the place, the same one, or null to remove it
 */
export function changeChannels(
  clip: ClipParts,
  keys: { has(key: ChannelKey): boolean },
  change: (channel: ChannelParts, key: ChannelKey) => ChannelParts | null,
): ClipParts {
  return withChannels(
    clip,
    clip.channels.flatMap((channel) => {
      const key = keyOf(channel);
      return key !== null && keys.has(key) ? (change(channel, key) ?? []) : channel;
    }),
  );
}

/** Changes one channel, if the clip has it. */
export function changeChannel(
  clip: ClipParts,
  key: ChannelKey,
  change: (channel: ChannelParts) => ChannelParts | null,
): ClipParts {
  return changeChannels(clip, new Set([key]), change);
}

/** Returns the clip itself if the channels are its own. */
function withChannels(clip: ClipParts, channels: readonly ChannelParts[]): ClipParts {
  const isSame =
    channels.length === clip.channels.length &&
    channels.every((each, at) => each === clip.channels[at]);
  return isSame ? clip : { ...clip, channels };
}
