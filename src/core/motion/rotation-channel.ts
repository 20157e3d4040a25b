import { quat } from 'gl-matrix';
import type { Extrapolation, RotationChannelParts, RotationCurve } from './clip-parts.ts';

/** A curve of a rotation over time through its keys. */
export interface RotationChannel {
  readonly before: Extrapolation;
  readonly after: Extrapolation;
  readonly curve: RotationCurve;
  /** (keyCount) seconds, increasing. */
  readonly times: Float64Array;
  /** (keyCount) unit quaternions xyzw, each in the hemisphere of the one before. */
  readonly values: readonly Float64Array[];
}

/** Compiles a curve, at the first call for it. */
export function rotationChannelFor(parts: RotationChannelParts): RotationChannel {
  let channel = compiled.get(parts);
  if (!channel) compiled.set(parts, (channel = compileRotation(parts)));
  return channel;
}

const compiled = new WeakMap<RotationChannelParts, RotationChannel>();

function compileRotation({ keys, before, after, target }: RotationChannelParts): RotationChannel {
  const values = keys.map(({ value }) => Float64Array.from(value));
  values.forEach((value, at) => {
    const former = values[at - 1];
    if (former && quat.dot(former, value) < 0) {
      value.forEach((part, i) => (value[i] = -part));
    }
  });
  const times = Float64Array.from(keys, ({ time }) => time);
  return { before, after, curve: target.curve, times, values };
}

/**
 * Writes the rotation at a time: the identity without keys, constant with one key.
 *
 * @param rotation (4) unit quaternion xyzw, written
 */
export function evaluateRotation(
  { times, values }: RotationChannel,
  time: number,
  rotation: Float64Array,
): void {
  const last = times.length - 1;
  if (last < 0) rotation.set([0, 0, 0, 1]);
  else if (time <= times[0]!) rotation.set(values[0]!);
  else if (time >= times[last]!) rotation.set(values[last]!);
  else {
    let span = 0;
    while (times[span + 1]! <= time) span++;
    const u = (time - times[span]!) / (times[span + 1]! - times[span]!);
    quat.slerp(rotation, values[span] as never, values[span + 1] as never, u);
  }
}
