import type { ClipParts } from '../clip-parts.ts';
import type { KeySelection } from '../key-selection.ts';
import { changeChannels } from './channels.ts';
import { withKeys } from './keys.ts';
import { indicesAt } from './selection.ts';

/** Removes keys; a channel that loses its last one goes too. */
export function removeKeys(clip: ClipParts, selection: KeySelection): ClipParts {
  return changeChannels(clip, selection, (channel, key) => {
    const removed = new Set(indicesAt(channel, selection.get(key)!));
    if (removed.size === 0) return channel;
    if (removed.size === channel.keys.length) return null;
    return withKeys(
      channel,
      [...channel.keys].filter((_, at) => !removed.has(at)),
    );
  });
}
