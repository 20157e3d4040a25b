import type { Character } from '../../core/character.ts';
import { clipFor, evaluateClip } from '../../core/motion/clip.ts';
import type { ChannelParts, ClipParts } from '../../core/motion/clip-parts.ts';
import type { RotationForm } from '../../core/motion/convert-rotation.ts';
import { DofKind } from '../../core/skeleton.ts';
import type { RotationMotion } from './chart-curve.ts';
import { ownRotation } from './joint-charts.ts';

/** What a clip does to the rotation of one joint. */
export interface JointMotion extends RotationMotion {
  /** The joint's values at each time, each the whole of q. */
  readonly values: readonly Float64Array[];
  /** How the clip keeps the rotation. */
  readonly stored: RotationForm;
  /** The times of the keys that turn the joint, in seconds, increasing. */
  readonly keys: readonly number[];
  /** All of q at a time, of which only the joint's values are of use; the next call overwrites it. */
  valuesAt(time: number): Float64Array;
}

/** Samples a second, and the least and the most of them in all. */
const [rate, fewest, most] = [60, 240, 2400];

/** Returns how a clip keeps a joint's rotation, or null if the clip does not turn it. */
function storedAs({ channels }: ClipParts, source: number): RotationForm | null {
  const turning = channels.filter((channel) => turnsJoint(channel, source));
  const curve = turning.flatMap(({ target }) => (target?.of === 'rotation' ? target.curve : []));
  return curve[0] ?? (turning.length > 0 ? 'euler' : null);
}

/**
 * Samples what a clip does to a joint in the range that is played, and at its keys within it. Returns
 * null if the clip does not turn the joint.
 *
 * @param q (qCount) the values that the clip does not move
 */
export function jointMotion(
  character: Character,
  joint: number,
  parts: ClipParts,
  q: Float64Array,
): JointMotion | null {
  const { skeleton } = character;
  const source = skeleton.sourceIndex[joint]!;
  const stored = storedAs(parts, source);
  if (!stored) return null;
  const { start, end } = parts;
  const channels = parts.channels.filter((channel) => turnsJoint(channel, source));
  const keys = increasing(channels.flatMap((channel) => channel.keys.map(({ time }) => time)));
  const count = Math.min(Math.max(Math.ceil((end - start) * rate), fewest), most);
  const even = Array.from({ length: count + 1 }, (_, i) => start + ((end - start) * i) / count);
  const times = increasing([...even, ...keys.filter((time) => time > start && time < end)]);
  const clip = clipFor({ ...parts, channels }, character);
  const nothing = new Float64Array(0);
  const written = { q: q.slice(), morphWeights: nothing, pins: nothing };
  const valuesAt = (time: number): Float64Array => {
    evaluateClip(clip, time, written);
    return written.q;
  };
  const values = times.map((time) => valuesAt(time).slice());
  const rotations = values.map((each) => ownRotation(skeleton, joint, each));
  return { times, rotations, values, stored, keys, valuesAt };
}

/** Whether a channel turns a joint: its rotation, or one of its hinges. */
export function turnsJoint({ target }: ChannelParts, source: number): boolean {
  if (target?.of === 'rotation') return target.joint === source;
  return target?.of === 'value' && target.kind === DofKind.hinge && target.joint === source;
}

function increasing(times: readonly number[]): number[] {
  return [...new Set(times)].sort((a, b) => a - b);
}
