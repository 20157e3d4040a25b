import { writeEuler } from '../euler.ts';
import { arcBetween } from './quaternions.ts';
import { evaluateRotation, type RotationChannel } from './rotation-channel.ts';
import { cycleAt, spanAt, timeInCycle } from './spans.ts';

/** The coordinate axes of three hinges, in the order of their product: 0 for x, 1 for y, 2 for z. */
export type HingeOrder = readonly [first: number, second: number, third: number];

/**
 * The angles of three hinges along a curve of rotations, without jumps. They are known at some times;
 * in between they are extracted from the rotation, of the equivalent ones those nearest to the way
 * from one known time to the next. So they depend on the time alone, not on how it was reached.
 */
export interface HingePath {
  readonly order: HingeOrder;
  /** 1 if the axes in their order are right-handed, otherwise -1. */
  readonly handedness: 1 | -1;
  /** (count) seconds, increasing, among them those of all keys. */
  readonly times: Float64Array;
  /** (count × 3) radians, in the order of the hinges, times the handedness. */
  readonly angles: Float64Array;
}

/** From one known time to the next no angle changes by more, in radians, except at a pole. */
const step = Math.PI / 4;

/** How many times a piece between two known times is halved at most: near a pole angles race. */
const depth = 10;

/** Follows the angles along a curve, at the first call for it and the order. */
export function hingePath(channel: RotationChannel, order: HingeOrder): HingePath {
  let paths = followed.get(channel);
  if (!paths) followed.set(channel, (paths = new Map<string, HingePath>()));
  const name = order.join();
  let path = paths.get(name);
  if (!path) paths.set(name, (path = follow(channel, order)));
  return path;
}

const followed = new WeakMap<RotationChannel, Map<string, HingePath>>();

function follow(channel: RotationChannel, order: HingeOrder): HingePath {
  const handedness = (order[1] - order[0] + 3) % 3 === 1 ? 1 : -1;
  const times: number[] = [];
  const angles: number[] = [];
  const rotation = new Float64Array(4);
  const found = new Float64Array(3);
  const add = (time: number): void => {
    times.push(time);
    angles.push(found[0]!, found[1]!, found[2]!);
  };
  const extract = (time: number, near: Float64Array): void => {
    evaluateRotation(channel, time, rotation);
    writeAngles(rotation, order, handedness, near, found);
  };
  const goTo = (time: number, halvings: number): void => {
    const from = times[times.length - 1]!;
    const former = Float64Array.from(angles.slice(-3));
    extract(time, former);
    const isFar = found.some((angle, i) => Math.abs(angle - former[i]!) > step);
    // Beyond a pole the nearest angles may not be those that a way beside it leads to.
    const isBeyond = Math.cos(found[1]!) * Math.cos(former[1]!) < 0;
    if ((isFar || isBeyond) && halvings > 0) {
      goTo((from + time) / 2, halvings - 1);
      goTo(time, halvings - 1);
    } else add(time);
  };
  channel.times.forEach((time, key) => {
    if (key === 0) {
      extract(time, found);
      add(time);
      return;
    }
    const from = channel.times[key - 1]!;
    const pieces = Math.max(1, Math.ceil(longestTurn(channel, key) / step));
    for (let i = 1; i < pieces; i++) goTo(from + ((time - from) * i) / pieces, depth);
    goTo(time, depth);
  });
  return { order, handedness, times: Float64Array.from(times), angles: Float64Array.from(angles) };
}

/**
 * At least how far a curve turns from the key before one to it, in radians: the ways between both
 * keys, and for a squad, which may leave them and come back, those by its control points.
 */
function longestTurn({ values, controls }: RotationChannel, key: number): number {
  const [from, to] = [key * 4 - 4, key * 4];
  const turn = 2 * arcBetween(values, from, values, to);
  if (controls.length === 0) return turn;
  const toControls =
    arcBetween(values, from, controls, from) + arcBetween(values, to, controls, to);
  return turn + 2 * (toControls + arcBetween(controls, from, controls, to));
}

/**
 * Writes the angles (3) of the hinges in their order. Outside the keys a curve that repeats has the
 * angles of its keys' range again, with 'cycle_offset' those that each repetition has turned on, and
 * another one those nearest to the end's.
 *
 * @param rotation unit quaternion xyzw of the curve at the time
 */
export function writeHingeAngles(
  path: HingePath,
  { before, after }: RotationChannel,
  time: number,
  rotation: Float64Array,
  angles: Float64Array,
): void {
  const { times, angles: known, order, handedness } = path;
  const last = times.length - 1;
  if (last < 0) angles.fill(0);
  else if (last === 0) angles.set(known);
  else {
    const rule = time < times[0]! ? before : after;
    // At the last key itself the curve does not begin again.
    const isOutside = time < times[0]! || time > times[last]!;
    const isRepeated = isOutside && rule !== 'constant' && rule !== 'linear';
    const cycle = isRepeated ? cycleAt(times, time) : 0;
    const inside = isRepeated ? timeInCycle(times, rule, time, cycle) : time;
    const repetitions = rule === 'cycle_offset' ? cycle : 0;
    const held = Math.min(Math.max(inside, times[0]!), times[last]!);
    const at = spanAt(times, held);
    const u = (held - times[at]!) / (times[at + 1]! - times[at]!);
    for (let i = 0; i < 3; i++) {
      const from = known[at * 3 + i]!;
      const gained = known[last * 3 + i]! - known[i]!;
      angles[i] = from + (known[at * 3 + 3 + i]! - from) * u + repetitions * gained;
    }
  }
  writeAngles(rotation, order, handedness, angles, angles);
  for (let i = 0; i < 3; i++) angles[i] = handedness * angles[i]!;
}

/**
 * Writes the angles nearest to others. In the frame of the hinges' axes the product of any three
 * hinges is Rx · Ry · Rz, with reversed signs of the angles if the frame is a reflection, so that
 * one extraction covers all orders.
 */
function writeAngles(
  rotation: Float64Array,
  order: HingeOrder,
  handedness: number,
  near: Float64Array,
  angles: Float64Array,
): void {
  const x = handedness * rotation[order[0]]!;
  const y = handedness * rotation[order[1]]!;
  const z = handedness * rotation[order[2]]!;
  const w = rotation[3]!;
  matrix[0] = 1 - 2 * (y * y + z * z);
  matrix[1] = 2 * (x * y + z * w);
  matrix[4] = 2 * (x * y - z * w);
  matrix[5] = 1 - 2 * (x * x + z * z);
  matrix[8] = 2 * (x * z + y * w);
  matrix[9] = 2 * (y * z - x * w);
  matrix[10] = 1 - 2 * (x * x + y * y);
  writeEuler(matrix, 'xyz', near, angles);
}

/** What the product of Rx · Ry · Rz needs of a column-major 4 × 4 matrix. */
const matrix = new Float64Array(11);
