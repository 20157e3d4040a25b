import { type ClipParts, isRotationChannel, type Tangent } from '../clip-parts.ts';
import type { KeySelection } from '../key-selection.ts';
import { changeChannels } from './channels.ts';
import { withKeys } from './keys.ts';
import { indicesAt } from './selection.ts';

export type TangentSide = 'in' | 'out' | 'both';

/** Sets the tangents of keys of one number, before them, after them, or on both sides. */
export function setTangents(
  clip: ClipParts,
  selection: KeySelection,
  side: TangentSide,
  tangent: Tangent,
): ClipParts {
  const tangents = {
    ...(side !== 'out' && { tangentIn: tangent }),
    ...(side !== 'in' && { tangentOut: tangent }),
  };
  return changeChannels(clip, selection, (channel, key) => {
    if (isRotationChannel(channel)) return channel;
    const selected = new Set(indicesAt(channel, selection.get(key)!));
    if (selected.size === 0) return channel;
    const keys = channel.keys.map((each, at) =>
      selected.has(at) ? { ...each, ...tangents } : each,
    );
    return withKeys(channel, keys);
  });
}
