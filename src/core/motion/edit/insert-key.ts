import { channelFor, evaluateChannel, isStepped } from '../channel.ts';
import {
  type ClipParts,
  isRotationChannel,
  type KeyParts,
  type RotationChannelParts,
  type ScalarChannelParts,
  type Tangent,
} from '../clip-parts.ts';
import { evaluateRotation, rotationChannelFor } from '../rotation-channel.ts';
import { slopesOf } from '../tangents.ts';
import type { ChannelKey } from '../targets.ts';
import { changeChannel, channelOf } from './channels.ts';
import { firstFrom, keyAt } from './keys.ts';

export interface InsertedKey {
  /** The same clip if no key was inserted. */
  readonly clip: ClipParts;
  /** Times of the keys whose slopes became numbers, increasing. */
  readonly fixed: readonly number[];
}

/**
 * Inserts a key on a curve. A curve of numbers does not change: the slopes of the key and of its
 * neighbors become numbers. A slerp does not change either; a squad does, by `squadTurnOnInsert`.
 *
 * There is no such key, and the clip is returned itself, where a key is already, and outside the
 * keys of a curve that repeats before or after them, because its period would change.
 */
export function insertKey(clip: ClipParts, key: ChannelKey, time: number): InsertedKey {
  const channel = channelOf(clip, key);
  if (
    !channel ||
    channel.keys.length === 0 ||
    keyAt(channel.keys, time) >= 0 ||
    isBeyond(channel, time)
  ) {
    return { clip, fixed: [] };
  }
  if (isRotationChannel(channel)) {
    return { clip: changeChannel(clip, key, () => rotationWith(channel, time)), fixed: [] };
  }
  const { keys, fixed } = scalarWith(channel, time);
  return { clip: changeChannel(clip, key, () => ({ ...channel, keys })), fixed };
}

/** Whether a time is outside of keys that are repeated on one of their sides. */
function isBeyond(
  { keys, before, after }: ScalarChannelParts | RotationChannelParts,
  time: number,
) {
  const isInside = time > keys[0]!.time && time < keys.at(-1)!.time;
  const isPlain = [before, after].every((rule) => rule === 'constant' || rule === 'linear');
  return !isInside && !isPlain && keys.length > 1;
}

/** A curve of rotations with a key on it more. */
export function rotationWith(channel: RotationChannelParts, time: number): RotationChannelParts {
  const rotation = new Float64Array(4);
  evaluateRotation(rotationChannelFor(channel), time, rotation);
  const [x, y, z, w] = rotation;
  const at = firstFrom(channel.keys, time);
  const value = [x!, y!, z!, w!] as const;
  return { ...channel, keys: channel.keys.toSpliced(at, 0, { time, value }) };
}

function scalarWith(
  channel: ScalarChannelParts,
  time: number,
): { readonly keys: readonly KeyParts[]; readonly fixed: readonly number[] } {
  const compiled = channelFor(channel);
  const { slopesIn, slopesOut } = compiled;
  const at = firstFrom(channel.keys, time);
  const tangent = tangentAt(channel, time, at);
  const value = evaluateChannel(compiled, time);
  const put: KeyParts = { time, value, tangentIn: tangent, tangentOut: tangent };
  const keys = channel.keys.toSpliced(at, 0, put);
  /** Where a key that was there stood. */
  const former = (index: number): number => (index < at ? index : index - 1);
  const isThere = (index: number): boolean => index >= 0 && index < keys.length;
  const fix = (index: number): void => {
    const { tangentIn, tangentOut } = keys[index]!;
    keys[index] = {
      ...keys[index]!,
      tangentIn: fixed(tangentIn, slopesIn[former(index)]!),
      tangentOut: fixed(tangentOut, slopesOut[former(index)]!),
    };
  };
  const neighbors = [at - 1, at + 1].filter(isThere);
  neighbors.forEach(fix);
  if (channel.keys.length === 1) {
    // The only key had no slope, whatever its tangents say.
    keys[neighbors[0]!] = { ...keys[neighbors[0]!]!, tangentIn: 0, tangentOut: 0 };
  } else if (at === 0) keys[1] = { ...keys[1]!, tangentIn: tangent };
  else if (at === channel.keys.length) keys[at - 1] = { ...keys[at - 1]!, tangentOut: tangent };
  // The automatic slope of an end also depends on the key after its neighbor.
  const slopes = slopesOf(keys);
  const farther = [at - 2, at + 2].filter(
    (index) =>
      isThere(index) &&
      (slopes.slopesIn[index] !== slopesIn[former(index)] ||
        slopes.slopesOut[index] !== slopesOut[former(index)]),
  );
  farther.forEach(fix);
  const changed = [...farther, ...neighbors, at].filter((index) => hasNumber(keys[index]!));
  return { keys, fixed: changed.sort((a, b) => a - b).map((index) => keys[index]!.time) };
}

/** The tangent on both sides of a key that is put on a curve before the key with an index. */
function tangentAt(channel: ScalarChannelParts, time: number, at: number): Tangent {
  const { keys, before, after } = channel;
  const { slopesIn, slopesOut, times, cubics } = channelFor(channel);
  if (keys.length === 1) return 0;
  if (at === 0) return before === 'linear' ? slopesIn[0]! : 0;
  if (at === keys.length) return after === 'linear' ? slopesOut.at(-1)! : 0;
  const span = at - 1;
  if (isStepped(keys, span)) return 'stepped';
  const seconds = times[at]! - times[span]!;
  const u = (time - times[span]!) / seconds;
  const [a, b, c] = cubics.subarray(span * 4);
  return ((3 * a! * u + 2 * b!) * u + c!) / seconds;
}

/** The slope as a number, except of stepped tangents, which say what the curve does. */
function fixed(tangent: Tangent, slope: number): Tangent {
  return tangent === 'stepped' ? tangent : slope;
}

function hasNumber({ tangentIn, tangentOut }: KeyParts): boolean {
  return typeof tangentIn === 'number' || typeof tangentOut === 'number';
}
