import type { EulerProduct } from '../../core/euler.ts';
import { channelFor, evaluateChannel } from '../../core/motion/channel.ts';
import type { KeyParts } from '../../core/motion/clip-parts.ts';
import { largestBetween } from './largest-between.ts';
import { type Angles, anglesOf, turnBetween, turnOf } from './turns.ts';

export interface SampledAngles {
  /** The keys of the angles about x, y and z; one key where an angle does not change. */
  readonly keys: readonly [readonly KeyParts[], readonly KeyParts[], readonly KeyParts[]];
  /** The largest turn in radians between the rotation and that of the angles. */
  readonly largest: number;
}

/**
 * Returns angles that turn as a rotation does at some times, smooth between them.
 *
 * @param rotationAt a unit quaternion xyzw at a time in seconds
 * @param near the angles that the first ones are to be near
 */
export function sampleAngles(
  rotationAt: (time: number) => ArrayLike<number>,
  times: readonly number[],
  product: EulerProduct,
  near: Angles = [0, 0, 0],
): SampledAngles {
  let former = near;
  const rows = times.map((time) => (former = anglesOf(rotationAt(time), product, former)));
  const keysOf = (axis: 0 | 1 | 2) =>
    smoothKeys(
      times,
      rows.map((row) => row[axis]),
    );
  const keys = [keysOf(0), keysOf(1), keysOf(2)] as const;
  const [x, y, z] = keys.map((each) =>
    channelFor({ target: null, before: 'constant', after: 'constant', keys: each }),
  );
  const largest = largestBetween(times, (time) => {
    const [ax, ay, az] = [x!, y!, z!].map((channel) => evaluateChannel(channel, time));
    return turnBetween(rotationAt(time), turnOf([ax!, ay!, az!], product));
  });
  return { keys, largest };
}

/** A smooth curve through values; a value that does not change is one key. */
export function smoothKeys(
  times: readonly number[],
  values: readonly number[],
): readonly KeyParts[] {
  const isStill = values.every((value) => value === values[0]);
  return (isStill ? times.slice(0, 1) : times).map((time, at) => ({
    time,
    value: values[at]!,
    tangentIn: 'smooth',
    tangentOut: 'smooth',
  }));
}
