import type { ClipParts } from '../clip-parts.ts';
import type { KeySelection } from '../key-selection.ts';
import type { ChannelKey } from '../targets.ts';
import { changeChannels } from './channels.ts';
import { type AnyKey, mergedKeys, withKeys } from './keys.ts';
import { type EditedKeys, indicesAt } from './selection.ts';

/** Replaces each selected key by another one, which also replaces what is at its time. */
export function placeKeys(
  clip: ClipParts,
  selection: KeySelection,
  place: (key: AnyKey) => AnyKey,
): EditedKeys {
  const placed = new Map<ChannelKey, readonly number[]>();
  const edited = changeChannels(clip, selection, (channel, key) => {
    const indices = indicesAt(channel, selection.get(key)!);
    if (indices.length === 0) return channel;
    const [put, kept]: [AnyKey[], AnyKey[]] = [[], []];
    channel.keys.forEach((each: AnyKey, at) => {
      if (indices[put.length] === at) put.push(place(each));
      else kept.push(each);
    });
    const keys = mergedKeys(kept, put);
    const own = new Set(put);
    placed.set(
      key,
      keys.filter((each) => own.has(each)).map(({ time }) => time),
    );
    return withKeys(channel, keys);
  });
  return { clip: edited, selection: placed };
}
