import { channelFor, evaluateChannel } from '../../core/motion/channel.ts';
import type { ScalarChannelParts, ScalarClipParts } from '../../core/motion/clip-parts.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { frameTimes } from './frame-times.ts';
import { windowOf } from './moved-joints.ts';
import { sampleAngles } from './sampled-angles.ts';
import { type Angles, productOf, turnOf } from './turns.ts';

/** A clip whose angles are those of the skeleton's own order of turns. */
export interface ReorderedAngles {
  readonly clip: ScalarClipParts;
  /** The number of joints that were sampled, and of those with too many frames, which have no curve. */
  readonly joints: number;
  readonly leftOut: number;
  /** The largest turn in radians between a rotation before and after. */
  readonly largest: number;
}

/**
 * The angles of an `.anim` turn by Rz · Ry · Rx. Where the joints of a skeleton turn in another order,
 * the same angles are another rotation, so that these are sampled at frames and their own angles take
 * their place. Curves about one axis alone turn alike in every order and stay.
 */
export function reorderAngles(clip: ScalarClipParts, skeleton: Skeleton): ReorderedAngles {
  const channels = [...clip.channels];
  let [joints, leftOut, largest] = [0, 0, 0];
  for (const [source, own] of anglesByJoint(channels)) {
    const joint = skeleton.jointOfSource[source];
    const product = joint === undefined ? null : productOf(skeleton, joint);
    if (product === null || product === 'zyx' || turningAxes(channels, own) < 2) continue;
    const curves = own.map((index) => channels[index]!);
    const compiled = curves.map((curve) => channelFor(curve));
    const anglesAt = (time: number): Angles => {
      const [x, y, z] = compiled.map((curve) => evaluateChannel(curve, time));
      return [x!, y!, z!];
    };
    const window = windowOf({ ...clip, channels: curves });
    const keys = curves.flatMap((curve) => curve.keys.map(({ time }) => time));
    const times = frameTimes([window.start, window.end], clip.fps, keys);
    if (!times) {
      leftOut++;
      for (const index of own) channels[index] = { ...channels[index]!, keys: [] };
      continue;
    }
    const turnAt = (time: number) => turnOf(anglesAt(time), 'zyx');
    const sampled = sampleAngles(turnAt, times, product, anglesAt(times[0]!));
    own.forEach((index, axis) => {
      const { before, after } = window;
      channels[index] = { ...channels[index]!, before, after, keys: sampled.keys[axis]! };
    });
    joints++;
    largest = Math.max(largest, sampled.largest);
  }
  return { clip: { ...clip, channels }, joints, leftOut, largest };
}

/** The indices of the channels about x, y and z, by the file index of their joint. */
function anglesByJoint(channels: readonly ScalarChannelParts[]): Map<number, readonly number[]> {
  const found = new Map<number, number[]>();
  channels.forEach(({ target }, index) => {
    if (target?.of !== 'value' || target.kind !== DofKind.hinge) return;
    const own = found.get(target.joint) ?? [];
    own[target.axis] = index;
    found.set(target.joint, own);
  });
  // A file that ends within a joint has too few channels for it.
  return new Map([...found].filter(([, own]) => own.length === 3));
}

/** About how many axes a joint turns at some time. */
function turningAxes(channels: readonly ScalarChannelParts[], own: readonly number[]): number {
  return own.filter((index) => !isZero(channels[index]!)).length;
}

/** A curve of zeros may still rise, by the slopes of its keys. */
function isZero({ keys }: ScalarChannelParts): boolean {
  return keys.every(
    ({ value, tangentIn, tangentOut }) =>
      value === 0 && !isSlope(tangentIn) && !isSlope(tangentOut),
  );
}

function isSlope(tangent: unknown): boolean {
  return typeof tangent === 'number' && tangent !== 0;
}
