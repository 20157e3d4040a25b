import type { ClipParts, Extrapolation } from '../clip-parts.ts';
import type { ChannelKey } from '../targets.ts';
import { changeChannel } from './channels.ts';

/** Sets how a channel continues before its first key or after its last one. */
export function setExtrapolation(
  clip: ClipParts,
  key: ChannelKey,
  side: 'before' | 'after',
  rule: Extrapolation,
): ClipParts {
  return changeChannel(clip, key, (channel) =>
    channel[side] === rule ? channel : { ...channel, [side]: rule },
  );
}
