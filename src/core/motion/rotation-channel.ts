import type { Extrapolation, RotationChannelParts, RotationCurve } from './clip-parts.ts';
import {
  copyRotation,
  exponential,
  logarithm,
  multiply,
  slerp,
  turnBetween,
} from './quaternions.ts';
import { cycleAt, spanAt, timeInCycle } from './spans.ts';

/** A curve of a rotation over time through its keys, with rules for times outside of them. */
export interface RotationChannel {
  readonly before: Extrapolation;
  readonly after: Extrapolation;
  readonly curve: RotationCurve;
  /** (keyCount) seconds, increasing. */
  readonly times: Float64Array;
  /** (keyCount × 4) unit quaternions xyzw, each in the hemisphere of the one before. */
  readonly values: Float64Array;
  /** (keyCount × 4) the inner control points of a squad; empty for a slerp. */
  readonly controls: Float64Array;
  /** (3) the logarithm of the turn from the first key to the last one, in the joint's space. */
  readonly offset: Float64Array;
}

/** Compiles a curve, at the first call for it; keys are at increasing times. */
export function rotationChannelFor(parts: RotationChannelParts): RotationChannel {
  let channel = compiled.get(parts);
  if (!channel) compiled.set(parts, (channel = compileRotation(parts)));
  return channel;
}

const compiled = new WeakMap<RotationChannelParts, RotationChannel>();

function compileRotation({ keys, before, after, target }: RotationChannelParts): RotationChannel {
  const { curve } = target;
  const times = Float64Array.from(keys, ({ time }) => time);
  const values = new Float64Array(keys.length * 4);
  keys.forEach(({ value: [x, y, z, w] }, key) => {
    const at = key * 4;
    const dot = key === 0 ? 1 : dotWith(values, at - 4, x, y, z, w);
    const sign = dot < 0 ? -1 : 1;
    values[at] = sign * x;
    values[at + 1] = sign * y;
    values[at + 2] = sign * z;
    values[at + 3] = sign * w;
  });
  const controls = curve === 'squad' ? controlsOf(values) : new Float64Array(0);
  return { before, after, curve, times, values, controls, offset: offsetOf(values) };
}

function dotWith(
  values: Float64Array,
  at: number,
  x: number,
  y: number,
  z: number,
  w: number,
): number {
  return values[at]! * x + values[at + 1]! * y + values[at + 2]! * z + values[at + 3]! * w;
}

/**
 * The control points of a squad: s = q · exp(−(log(q⁻¹ · next) + log(q⁻¹ · former)) / 4), and at
 * both ends the key itself. (Shoemake 1987, "Quaternion calculus and fast animation".)
 */
function controlsOf(values: Float64Array): Float64Array {
  const controls = values.slice();
  const [turn, toNext, toFormer] = [new Float64Array(4), new Float64Array(3), new Float64Array(3)];
  for (let at = 4; at < values.length - 4; at += 4) {
    turnBetween(turn, values, at, values, at + 4);
    logarithm(toNext, turn);
    turnBetween(turn, values, at, values, at - 4);
    logarithm(toFormer, turn);
    for (let i = 0; i < 3; i++) toNext[i]! += toFormer[i]!;
    exponential(turn, toNext, -0.25);
    multiply(turn, values, at, turn, 0);
    controls.set(turn, at);
  }
  return controls;
}

/** The logarithm of last · first⁻¹. */
function offsetOf(values: Float64Array): Float64Array {
  const offset = new Float64Array(3);
  const last = values.length - 4;
  if (last < 4) return offset;
  const inverse = Float64Array.of(-values[0]!, -values[1]!, -values[2]!, values[3]!);
  multiply(inverse, values, last, inverse, 0);
  logarithm(offset, inverse);
  return offset;
}

/**
 * Writes the rotation at a time: the identity without keys, constant with one key. Outside the keys
 * 'linear' goes on with the angular velocity at the end, and 'cycle_offset' turns each repetition
 * on from the one before.
 *
 * @param time in seconds
 * @param rotation (4) unit quaternion xyzw, written
 */
export function evaluateRotation(
  channel: RotationChannel,
  time: number,
  rotation: Float64Array,
): void {
  const { times, values, before, after } = channel;
  const last = times.length - 1;
  if (last < 0) rotation.fill(0)[3] = 1;
  else if (last === 0) copyRotation(rotation, values, 0);
  else if (time < times[0]!) extrapolate(channel, before, time, 0, rotation);
  else if (time > times[last]!) extrapolate(channel, after, time, last, rotation);
  else insideRotation(channel, time, rotation);
}

/** @param end the nearer key */
function extrapolate(
  channel: RotationChannel,
  rule: Extrapolation,
  time: number,
  end: number,
  rotation: Float64Array,
): void {
  const { times, values } = channel;
  if (rule === 'constant') copyRotation(rotation, values, end * 4);
  else if (rule === 'linear') {
    // At its ends, where the control point is the key, a squad has the velocity of the slerp.
    const span = Math.max(0, end - 1);
    slerp(rotation, values, span * 4, values, span * 4 + 4, fractionOf(times, span, time));
  } else {
    const cycle = cycleAt(times, time);
    insideRotation(channel, timeInCycle(times, rule, time, cycle), rotation);
    if (rule !== 'cycle_offset') return;
    exponential(turned, channel.offset, cycle);
    multiply(rotation, turned, 0, rotation, 0);
  }
}

/** The rotation at a time between the first and the last key. */
function insideRotation(
  { times, values, controls }: RotationChannel,
  time: number,
  rotation: Float64Array,
): void {
  const last = times.length - 1;
  if (time >= times[last]!) {
    copyRotation(rotation, values, last * 4);
    return;
  }
  const span = spanAt(times, time);
  const at = span * 4;
  const u = Math.max(0, fractionOf(times, span, time));
  slerp(rotation, values, at, values, at + 4, u);
  if (controls.length === 0) return;
  slerp(turned, controls, at, controls, at + 4, u);
  slerp(rotation, rotation, 0, turned, 0, 2 * u * (1 - u));
}

const turned = new Float64Array(4);

/** The fraction of a span that has passed at a time. */
function fractionOf(times: Float64Array, span: number, time: number): number {
  return (time - times[span]!) / (times[span + 1]! - times[span]!);
}
