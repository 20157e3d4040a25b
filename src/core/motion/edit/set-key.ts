import { assert } from '../../assert.ts';
import type {
  ChannelParts,
  ChannelTarget,
  ClipParts,
  KeyParts,
  Quaternion,
  Tangent,
} from '../clip-parts.ts';
import { type ChannelKey, channelKey } from '../targets.ts';
import { changeChannel, channelOf } from './channels.ts';
import { type AnyKey, isScalarKey, keyAt, mergedKeys, withKeys } from './keys.ts';
import { placeKeys } from './place-keys.ts';
import type { EditedKeys } from './selection.ts';

/**
 * Sets the value of the target's channel at a time, and makes the channel if there is none. A key
 * at the time keeps its tangents; a new key is automatic.
 *
 * @param time in seconds
 * @param value a quaternion for a rotation, else a number
 */
export function setKey(
  clip: ClipParts,
  target: ChannelTarget,
  time: number,
  value: number | Quaternion,
): ClipParts {
  const put = newKey(target, time, value);
  const key = channelKey(target);
  if (!channelOf(clip, key)) {
    const made = { target, before: 'constant', after: 'constant', keys: [put] } as ChannelParts;
    return { ...clip, channels: [...clip.channels, made] };
  }
  return changeChannel(clip, key, (channel) => {
    const at = keyAt(channel.keys, time);
    const keys: readonly AnyKey[] = channel.keys;
    if (at < 0) return withKeys(channel, mergedKeys(keys, [put]));
    return withKeys(channel, keys.with(at, { ...keys[at]!, value } as AnyKey));
  });
}

function newKey(target: ChannelTarget, time: number, value: number | Quaternion): AnyKey {
  assert(
    (target.of === 'rotation') === (typeof value !== 'number'),
    'a value that fits the target',
  );
  return typeof value === 'number'
    ? { time, value, tangentIn: 'auto', tangentOut: 'auto' }
    : { time, value };
}

/** What to change of a key; tangents only of a key of one number. */
export interface KeyChange {
  readonly time?: number;
  readonly value?: number | Quaternion;
  readonly tangentIn?: Tangent;
  readonly tangentOut?: Tangent;
}

/** Changes the key at a time, if there is one. At its new time it replaces another key. */
export function changeKey(
  clip: ClipParts,
  key: ChannelKey,
  time: number,
  change: KeyChange,
): EditedKeys {
  return placeKeys(clip, new Map([[key, [time]]]), (each) => {
    const placed = change.time ?? each.time;
    if (!isScalarKey(each)) {
      const { value = each.value } = change;
      assert(typeof value !== 'number', 'a rotation');
      return { time: placed, value };
    }
    const changed = { ...each, ...change, time: placed };
    assert(typeof changed.value === 'number', 'a number');
    return changed as KeyParts;
  });
}
