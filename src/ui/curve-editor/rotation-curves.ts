import type { RotationChannelParts } from '../../core/motion/clip-parts.ts';
import { evaluateRotation, rotationChannelFor } from '../../core/motion/rotation-channel.ts';

/** A rotation over time as the three parts of its rotation vector, in radians, without jumps. */
export interface RotationCurves {
  /** (sampleCount) seconds, increasing; the times of all keys are among them. */
  readonly times: Float64Array;
  /** Three lists of (sampleCount). */
  readonly parts: readonly [Float64Array, Float64Array, Float64Array];
}

const samplesASpan = 24;
const mostSamples = 20_000;

/** Samples a rotation between its keys, at the first call for it. */
export function rotationCurvesOf(channel: RotationChannelParts): RotationCurves {
  let curves = sampled.get(channel);
  if (!curves) sampled.set(channel, (curves = sample(channel)));
  return curves;
}

const sampled = new WeakMap<RotationChannelParts, RotationCurves>();

function sample(channel: RotationChannelParts): RotationCurves {
  const { keys } = channel;
  const spans = Math.max(0, keys.length - 1);
  const each = Math.max(1, Math.min(samplesASpan, Math.floor(mostSamples / Math.max(1, spans))));
  const times = new Float64Array(keys.length === 0 ? 0 : spans * each + 1);
  for (let i = 0; i < times.length; i++) {
    const [span, step] = [Math.floor(i / each), i % each];
    const start = keys[span]!.time;
    times[i] = step === 0 ? start : start + ((keys[span + 1]!.time - start) * step) / each;
  }
  const parts = [0, 1, 2].map(() => new Float64Array(times.length));
  const compiled = rotationChannelFor(channel);
  const rotation = new Float64Array(4);
  let former: readonly number[] = [0, 0, 0];
  times.forEach((time, i) => {
    evaluateRotation(compiled, time, rotation);
    former = nearestVector(rotation, former);
    former.forEach((part, axis) => (parts[axis]![i] = part));
  });
  const [x, y, z] = parts;
  return { times, parts: [x!, y!, z!] };
}

/** The rotation vector of a unit quaternion, of all that turn alike the one nearest to another. */
function nearestVector(
  [x, y, z, w]: ArrayLike<number> & Iterable<number>,
  former: readonly number[],
): readonly number[] {
  const sine = Math.hypot(x!, y!, z!);
  if (sine < 1e-9) return nearestWholeTurn(former);
  const axis = [x! / sine, y! / sine, z! / sine];
  const angle = 2 * Math.atan2(sine, w!);
  const along = axis.reduce((sum, part, i) => sum + part * former[i]!, 0);
  const turns = Math.round((along - angle) / (2 * Math.PI));
  return axis.map((part) => part * (angle + turns * 2 * Math.PI));
}

/** No turn at all, or whole turns about the axis of before. */
function nearestWholeTurn(former: readonly number[]): readonly number[] {
  const length = Math.hypot(...former);
  const turns = Math.round(length / (2 * Math.PI));
  if (turns === 0) return [0, 0, 0];
  return former.map((part) => (part / length) * turns * 2 * Math.PI);
}

/** A part of the rotation vector at a time, held outside of the keys. */
export function rotationPartAt(
  { times, parts }: RotationCurves,
  axis: 0 | 1 | 2,
  time: number,
): number {
  const values = parts[axis];
  const last = times.length - 1;
  if (last < 0) return 0;
  if (time <= times[0]!) return values[0]!;
  if (time >= times[last]!) return values[last]!;
  let [below, above] = [0, last];
  while (above - below > 1) {
    const middle = (below + above) >> 1;
    if (times[middle]! <= time) below = middle;
    else above = middle;
  }
  const part = (time - times[below]!) / (times[above]! - times[below]!);
  return values[below]! + (values[above]! - values[below]!) * part;
}
