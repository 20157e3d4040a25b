import { assert } from '../../core/assert.ts';
import { jointRange } from '../../core/pose.ts';
import { DofKind } from '../../core/skeleton.ts';
import type { IkOptions, IkProblem } from './problem.ts';
import type { TangentSpace } from './tangent-space.ts';

/** The part of a range, from its start, inside which random starts are. */
const inside = [0.15, 0.85] as const;
/** Values without limits start at most this far from the reference, in radians. */
const farthest = 2;

/** Where a solve starts: within the limits, and in the other joints as the reference. */
export function startOf(
  { skeleton, joints, reference }: IkProblem,
  { from = reference }: IkOptions,
): Float64Array {
  assert(from.length === skeleton.qRest.length, 'a start with all values of the skeleton');
  const q = reference.slice();
  for (const joint of joints) {
    const [first, end] = jointRange(skeleton, joint);
    for (let i = first; i < end; i++) q[i] = clamp(from[i]!, skeleton.qMin[i]!, skeleton.qMax[i]!);
  }
  return q;
}

/**
 * Other poses from which a solve that stalled can start: the first is the middle of the limits, and
 * the others are random inside 15 to 85 % of each range. The same number always gives the same pose.
 *
 * @param reference (qCount) the values without limits start near these
 */
export function startPose(
  space: TangentSpace,
  reference: Float64Array,
  index: number,
): Float64Array {
  const q = reference.slice();
  const random = randomNumbers(index);
  for (let column = 0; column < space.columnCount; column++) {
    const at = space.values[column]!;
    const part = index === 0 ? 0.5 : inside[0] + (inside[1] - inside[0]) * random();
    const [min, max] = [space.min[column]!, space.max[column]!];
    if (Number.isFinite(min) && Number.isFinite(max)) q[at] = min + part * (max - min);
    else if (index > 0 && space.kinds[column] === DofKind.hinge)
      q[at] = clamp(q[at]! + farthest * (2 * part - 1), min, max);
    else if (index > 0 && space.kinds[column] === DofKind.ball && space.axes[column] === 0) {
      const axis = [random() - 0.5, random() - 0.5, random() - 0.5] as const;
      turn(q, at, axis, farthest * part);
    }
  }
  return q;
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(Math.max(value, min), max);
}

/** Rotates a ball about an axis, from the left; the axis need not be a unit vector. */
function turn(q: Float64Array, at: number, axis: readonly number[], angle: number): void {
  const length = Math.hypot(...axis) || 1;
  const [x, y, z] = axis.map((part) => (part / length) * Math.sin(0.5 * angle));
  const w = Math.cos(0.5 * angle);
  const [bx, by, bz, bw] = q.subarray(at, at + 4);
  q[at] = w * bx! + x! * bw! + y! * bz! - z! * by!;
  q[at + 1] = w * by! - x! * bz! + y! * bw! + z! * bx!;
  q[at + 2] = w * bz! + x! * by! - y! * bx! + z! * bw!;
  q[at + 3] = w * bw! - x! * bx! - y! * by! - z! * bz!;
}

/** Numbers from 0 to 1 that depend on the seed alone (mulberry32 by T. Ettinger, public domain). */
function randomNumbers(seed: number): () => number {
  let state = (seed * 0x9e3779b9) | 0;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 0x1_0000_0000;
  };
}
