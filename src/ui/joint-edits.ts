import type { Skeleton } from '../core/skeleton.ts';
import type { Posing } from './editor.ts';
import { type JointValue, jointValues } from './joint-values.ts';

type Angles = Pick<Posing, 'ballAngles'>;

/** A number of a joint in a pose, as the interface shows it. */
export function valueIn(
  { ballAngles }: Angles,
  skeleton: Skeleton,
  q: Float64Array,
  { index, axis, ofBall }: JointValue,
): number {
  return ofBall ? ballAngles.of(skeleton, q, index)[axis] : (q[index] ?? 0);
}

/**
 * Returns the pose in which a number of the first of some joints is set, and the same numbers of the
 * others are changed by as much, within their limits.
 *
 * @param q (qCount) the pose before
 * @param number may exceed the limits of the first joint, if the caller wants that
 */
export function withValue(
  angles: Angles,
  skeleton: Skeleton,
  q: Float64Array,
  joints: readonly number[],
  value: JointValue,
  number: number,
): Float64Array {
  const change = number - valueIn(angles, skeleton, q, value);
  return joints.slice(1).reduce(
    (next, joint) => {
      const same = jointValues(skeleton, joint).find(
        ({ isAngle, axis }) => isAngle === value.isAngle && axis === value.axis,
      );
      if (!same) return next;
      const wanted = valueIn(angles, skeleton, q, same) + change;
      return withOne(angles, skeleton, next, same, withinLimits(skeleton, same, wanted));
    },
    withOne(angles, skeleton, q, value, number),
  );
}

/** The number that is nearest to a wanted one within the limits of a joint. */
export function withinLimits(
  { qMin, qMax }: Skeleton,
  { index, ofBall }: JointValue,
  wanted: number,
): number {
  return ofBall ? wanted : Math.min(Math.max(wanted, qMin[index]!), qMax[index]!);
}

function withOne(
  { ballAngles }: Angles,
  skeleton: Skeleton,
  q: Float64Array,
  { index, axis, ofBall }: JointValue,
  number: number,
): Float64Array {
  if (ofBall) return ballAngles.withAngle(skeleton, q, index, axis, number);
  const next = q.slice();
  next[index] = number;
  return next;
}
