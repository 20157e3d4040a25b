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

/** The channels of a motion that can be used, in the order of its file. */
export function channelsOfMotion({ channels }: Motion): readonly SampledChannel[] {
  return channels.map(({ target, curve }) => ({
    names: target.names,
    valueAt: evaluatorOf(curve),
  }));
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

/** The channel of a name; a clear name goes before a short one. */
export function channelNamed(
  channels: readonly SampledChannel[],
  name: string,
): SampledChannel | undefined {
  return (
    channels.find(({ names }) => names[0] === name) ??
    channels.find(({ names }) => names.includes(name))
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
