import { vec3 } from 'gl-matrix';
import { jointRange } from '../core/pose.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { withinLimits } from './joint-frames.ts';
import { turnAbout, turnFreely, type TurnStart, turnStart } from './turn-joint.ts';

/** How far a value may exceed a limit by rounding and still count as within it. */
const slack = 1e-10;
/** Up to this sine, a hinge's axis and a bone count as parallel. */
const parallel = 1e-9;

/**
 * Returns the values that roll a joint by `angle` about the line from its pivot to the far end of
 * its bone, which stays in place. A positive angle is counterclockwise seen from the far end. The
 * roll ends at the joint's limits. A joint that can't roll without moving its far end does not
 * move.
 *
 * @param farEnd of the bone, in the joint's frame
 * @param angle radians
 */
export function rollJoint(
  skeleton: Skeleton,
  q: Float64Array,
  joint: number,
  farEnd: readonly [number, number, number],
  angle: number,
): Float64Array {
  return rollFrom(turnStart(skeleton, joint, q), farEnd, angle, q);
}

/**
 * Like `rollJoint`, for a turn that has begun; of equivalent values those nearest to `near` are
 * taken.
 */
export function rollFrom(
  start: TurnStart,
  farEnd: readonly [number, number, number],
  angle: number,
  near: Float64Array,
): Float64Array {
  const axis = rollAxis(start, farEnd);
  if (!axis || angle === 0) return start.q.slice();
  const rolled = (part: number): Float64Array | null =>
    turnFreely(start, turnAbout(axis, part), part === angle ? near : start.q);
  const all = rolled(angle);
  if (!all) return rollHinge(start, axis, angle);
  const reached = isWithin(start, all) ? all : farthest(start, rolled, angle);
  return withinLimits(start.skeleton, start.joint, reached);
}

/** Unit vector in the character's space, or null if the far end is at the joint's pivot. */
export function rollAxis(start: TurnStart, farEnd: readonly [number, number, number]): vec3 | null {
  const end = vec3.transformMat4(new Float64Array(3), farEnd, start.frames.characterFromJoint);
  vec3.subtract(end, end, start.pivot);
  return vec3.length(end) > 0 ? vec3.normalize(end, end) : null;
}

/** The farthest roll toward `angle` whose values are within the limits, by bisection. */
function farthest(
  start: TurnStart,
  rolled: (part: number) => Float64Array | null,
  angle: number,
): Float64Array {
  let best = start.q;
  let [good, bad] = [0, 1];
  for (let step = 0; step < 40; step++) {
    const middle = (good + bad) / 2;
    const values = rolled(angle * middle);
    if (values && isWithin(start, values)) [good, best] = [middle, values];
    else bad = middle;
  }
  return best;
}

/** One or two hinges can roll a bone only if one of them is parallel to it. */
function rollHinge(start: TurnStart, axis: vec3, angle: number): Float64Array {
  const { skeleton, joint, q, free } = start;
  const next = q.slice();
  const hinge = free.find(
    (each) => vec3.length(vec3.cross(new Float64Array(3), each.axis, axis)) < parallel,
  );
  if (hinge) next[hinge.index]! += Math.sign(vec3.dot(hinge.axis, axis)) * angle;
  return withinLimits(skeleton, joint, next);
}

function isWithin({ skeleton, joint }: TurnStart, q: Float64Array): boolean {
  const [from, to] = jointRange(skeleton, joint);
  for (let i = from; i < to; i++) {
    if (q[i]! < skeleton.qMin[i]! - slack || q[i]! > skeleton.qMax[i]! + slack) return false;
  }
  return true;
}
