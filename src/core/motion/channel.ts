import type { Extrapolation, ScalarChannelParts } from './clip-parts.ts';
import { cycleAt, spanAt, timeInCycle } from './spans.ts';
import { slopesOf } from './tangents.ts';

/**
 * A curve over time through its keys: cubic Hermite spans, with rules for times outside the keys.
 * The formulas are from CSE169, project 3; a span is a·u³ + b·u² + c·u + d with u from 0 to 1.
 */
export interface Channel {
  readonly before: Extrapolation;
  readonly after: Extrapolation;
  /** (keyCount) seconds, increasing. */
  readonly times: Float64Array;
  /** (keyCount) */
  readonly values: Float64Array;
  /** (keyCount) slopes before and after each key, in value per second. */
  readonly slopesIn: Float64Array;
  readonly slopesOut: Float64Array;
  /** (max(0, keyCount - 1) × 4) a b c d of each span. */
  readonly cubics: Float64Array;
}

/** Compiles a curve, at the first call for it; keys are at increasing times. */
export function channelFor(parts: ScalarChannelParts): Channel {
  let channel = compiled.get(parts);
  if (!channel) compiled.set(parts, (channel = compileChannel(parts)));
  return channel;
}

const compiled = new WeakMap<ScalarChannelParts, Channel>();

/** @param parts keys at increasing times */
function compileChannel({ keys, before, after }: ScalarChannelParts): Channel {
  const times = new Float64Array(keys.length);
  const values = new Float64Array(keys.length);
  keys.forEach(({ time, value }, at) => {
    times[at] = time;
    values[at] = value;
  });
  const { slopesIn, slopesOut } = slopesOf(keys);
  const spanCount = Math.max(0, keys.length - 1);
  const cubics = new Float64Array(spanCount * 4);
  for (let span = 0; span < spanCount; span++) {
    const p0 = values[span]!;
    const p1 = values[span + 1]!;
    cubics[span * 4 + 3] = p0;
    if (isStepped(keys, span)) continue;
    const h = times[span + 1]! - times[span]!;
    const v0 = h * slopesOut[span]!;
    const v1 = h * slopesIn[span + 1]!;
    cubics[span * 4] = 2 * p0 - 2 * p1 + v0 + v1;
    cubics[span * 4 + 1] = -3 * p0 + 3 * p1 - 2 * v0 - v1;
    cubics[span * 4 + 2] = v0;
  }
  return { before, after, times, values, slopesIn, slopesOut, cubics };
}

/** Whether the span after a key keeps the key's value. */
export function isStepped(keys: ScalarChannelParts['keys'], span: number): boolean {
  return keys[span]!.tangentOut === 'stepped' || keys[span + 1]?.tangentIn === 'stepped';
}

/** The curve's value at a time in seconds: 0 without keys, constant with one key. */
export function evaluateChannel(channel: Channel, time: number): number {
  const { times, values } = channel;
  const last = times.length - 1;
  if (last <= 0) return values[0] ?? 0;
  if (time < times[0]!) return extrapolate(channel, channel.before, time, 0, channel.slopesIn);
  if (time > times[last]!) {
    return extrapolate(channel, channel.after, time, last, channel.slopesOut);
  }
  return insideValue(channel, time);
}

function extrapolate(
  channel: Channel,
  rule: Extrapolation,
  time: number,
  end: number,
  slopes: Float64Array,
): number {
  const { times, values } = channel;
  if (rule === 'constant') return values[end]!;
  if (rule === 'linear') return values[end]! + slopes[end]! * (time - times[end]!);
  const cycle = cycleAt(times, time);
  const value = insideValue(channel, timeInCycle(times, rule, time, cycle));
  return rule === 'cycle_offset'
    ? value + cycle * (values[values.length - 1]! - values[0]!)
    : value;
}

/**
 * The value at a time between the first and the last key; at both keys it is exactly the key's
 * value.
 */
function insideValue({ times, values, cubics }: Channel, time: number): number {
  const last = times.length - 1;
  if (time >= times[last]!) return values[last]!;
  const span = spanAt(times, time);
  const u = Math.max(0, (time - times[span]!) / (times[span + 1]! - times[span]!));
  const at = span * 4;
  return ((cubics[at]! * u + cubics[at + 1]!) * u + cubics[at + 2]!) * u + cubics[at + 3]!;
}
