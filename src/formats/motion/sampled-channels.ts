import { channelFor, evaluateChannel } from '../../core/motion/channel.ts';
import type { ScalarClipParts } from '../../core/motion/clip-parts.ts';
import { evaluateRotation, rotationChannelFor } from '../../core/motion/rotation-channel.ts';
import type { Motion, NamedCurve } from './motion.ts';

/** A channel that can be evaluated without a character. */
export interface SampledChannel {
  /** By which it is asked for, the clearest one first. */
  readonly names: readonly string[];
  /** A number, or a unit quaternion xyzw. */
  valueAt(time: number): number | readonly number[];
}

/** The channels of a motion in the order of its file; undefined where one can't be used. */
export function channelsOfMotion({ listed }: Motion): readonly (SampledChannel | undefined)[] {
  return listed.map(
    (each) => each && { names: each.target.names, valueAt: evaluatorOf(each.curve) },
  );
}

/**
 * The channels of an `.anim`, which names nothing: x, y, z of the root's translation, then three
 * angles of each joint by its number.
 */
export function channelsOfAnim({ channels }: ScalarClipParts): readonly SampledChannel[] {
  return channels.map((parts, index) => {
    const axis = 'xyz'[index % 3]!;
    const name = index < 3 ? `#0.t${axis}` : `#${Math.floor(index / 3) - 1}.r${axis}`;
    return { names: [name], valueAt: (time) => evaluateChannel(channelFor(parts), time) };
  });
}

/** The channel of a name, of several the last one; a clear name goes before a short one. */
export function channelNamed(
  channels: readonly (SampledChannel | undefined)[],
  name: string,
): SampledChannel | undefined {
  return (
    channels.findLast((each) => each?.names[0] === name) ??
    channels.findLast((each) => each?.names.includes(name))
  );
}

function evaluatorOf(curve: NamedCurve): SampledChannel['valueAt'] {
  const { before, after } = curve;
  if (curve.of === 'number') {
    const channel = channelFor({ target: null, before, after, keys: curve.keys });
    return (time) => evaluateChannel(channel, time);
  }
  // Which joint turns does not change the curve.
  const target = { of: 'rotation', joint: 0, curve: curve.curve } as const;
  const channel = rotationChannelFor({ target, before, after, keys: curve.keys });
  return (time) => {
    const rotation = new Float64Array(4);
    evaluateRotation(channel, time, rotation);
    return [...rotation];
  };
}
