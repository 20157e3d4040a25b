import { channelFor, evaluateChannel, isStepped } from '../../core/motion/channel.ts';
import type { KeyParts, ScalarChannelParts, Tangent } from '../../core/motion/clip-parts.ts';
import { slopesOf } from '../../core/motion/tangents.ts';
import { largestBetween } from '../motion/largest-between.ts';

/** A curve with the tangents that an `.anim` has, and what that changed. */
export interface PlainCurve {
  readonly channel: ScalarChannelParts;
  /** How many rules became slopes as numbers. */
  readonly fixed: number;
  /** The largest change of value that this makes. */
  readonly change: number;
  /** How many spans that keep a value and then jump became flat ones that end steeply. */
  readonly steps: number;
  /** The largest jump of these. */
  readonly jump: number;
}

/** How long the steep part takes in seconds; less in short spans. */
const steepTime = 1e-3;

/** Replaces the tangents that an `.anim` does not have. */
export function plainTangents(channel: ScalarChannelParts): PlainCurve {
  const { keys } = channel;
  const { slopesIn, slopesOut } = slopesOf(keys);
  const plain: KeyParts[] = [];
  let [fixed, steps, jump] = [0, 0, 0];
  keys.forEach((key, at) => {
    const [stepBefore, stepAfter] = [at > 0 && isStepped(keys, at - 1), isStepped(keys, at)];
    const isEnd = at === keys.length - 1;
    // A key that is put in between changes what the rules of its neighbors give; "linear" only where
    // its span is that one, as at the ends, from where the curve may go on by it.
    const isBesideStep = stepBefore || (stepAfter && !isEnd);
    const isBent = isBesideStep && (at === 0 || isEnd);
    const tangent = (rule: Tangent, slope: number): Tangent => {
      if (rule === 'stepped') return 'flat';
      if (rule === 'flat' || typeof rule === 'number') return rule;
      if (rule === 'linear' && !isBent) return rule;
      if (rule === 'smooth' && !isBesideStep) return rule;
      fixed++;
      return slope;
    };
    plain.push({
      ...key,
      tangentIn: stepBefore ? 'linear' : tangent(key.tangentIn, slopesIn[at]!),
      tangentOut: stepAfter && !isEnd ? 'flat' : tangent(key.tangentOut, slopesOut[at]!),
    });
    const next = keys[at + 1];
    if (!stepAfter || !next) return;
    const time = next.time - Math.min(steepTime, (next.time - key.time) / 2);
    plain.push({ time, value: key.value, tangentIn: 'flat', tangentOut: 'linear' });
    steps++;
    jump = Math.max(jump, Math.abs(next.value - key.value));
  });
  const made = { ...channel, keys: plain };
  return { channel: made, fixed, change: changeOf(channel, made), steps, jump };
}

/** The largest difference of two curves between their keys, except where one is steep. */
function changeOf(before: ScalarChannelParts, after: ScalarChannelParts): number {
  const [old, now] = [channelFor(before), channelFor(after)];
  const steep = after.keys.filter(({ tangentOut }, at) => {
    const next = after.keys[at + 1];
    return tangentOut === 'linear' && next && next.time - after.keys[at]!.time <= steepTime;
  });
  const times = before.keys.map((key) => key.time);
  return largestBetween(times, (time) => {
    const isSteep = steep.some((key) => time >= key.time && time <= key.time + steepTime);
    return isSteep ? 0 : Math.abs(evaluateChannel(old, time) - evaluateChannel(now, time));
  });
}
