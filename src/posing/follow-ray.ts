import { vec3 } from 'gl-matrix';
import { pointOnRay, type Ray, sphereSpan } from '../core/ray.ts';
import { withinLimits } from './joint-frames.ts';
import { reachPoint } from './reach-point.ts';
import { nearestValue } from './single-value.ts';
import { shortestTurn, turnFreely, type TurnStart } from './turn-joint.ts';

/**
 * How much nearer a solution from another start must be, as a fraction of the reach, to be
 * preferred.
 */
const better = 1e-3;

/**
 * Rotates a joint so that a point of it follows a ray, always from the start. The point can be
 * anywhere on the sphere about the joint's pivot. It moves to where the ray meets the sphere, on
 * the near or the far side, whichever it began on; if the ray misses, it moves to the sphere's
 * silhouette.
 *
 * A ball or three hinges take the shortest rotation that does this. If limits prevent it, or if
 * there are only two hinges, the point comes as near as they allow. A single hinge moves the point
 * nearest to the ray.
 *
 * @param grabbed the point at the start, in the character's space; `held` is the same in the
 * joint's frame
 */
export function followRay(
  start: TurnStart,
  grabbed: vec3,
  held: vec3,
  startRay: Ray,
): (ray: Ray, present: Float64Array) => Float64Array {
  const { skeleton, joint, pivot, free, q } = start;
  const arm = vec3.subtract(new Float64Array(3), grabbed, pivot);
  const reach = vec3.length(arm);
  const isFar = vec3.dot(arm, startRay.direction) > 0;
  if (reach === 0 || (!start.ball && free.length === 0)) return () => q.slice();

  return (ray, present) => {
    if (!start.ball && free.length === 1) {
      const dof = free[0]!;
      const [value, min, max] = [q, skeleton.qMin, skeleton.qMax].map((all) => all[dof.index]!);
      const single = { dof, value: value!, min: min!, max: max! };
      const next = q.slice();
      next[dof.index] = nearestValue(single, grabbed, ray, present[dof.index]!);
      return withinLimits(skeleton, joint, next);
    }
    const target = onSphere(ray, pivot, reach, isFar);
    if (start.ball || (start.triple && free.length === 3)) {
      const to = vec3.subtract(new Float64Array(3), target, pivot);
      const turned = turnFreely(start, shortestTurn(arm, to, ray.direction), present)!;
      const clamped = withinLimits(skeleton, joint, turned);
      if (start.ball || turned.every((value, i) => value === clamped[i])) return clamped;
      return reachPoint(start, held, target, clamped).q;
    }
    const fromStart = reachPoint(start, held, target, q);
    if (free.length > 2) return fromStart.q;
    // Two hinges have isolated solutions: the one nearest to the present values may be a better
    // minimum.
    const fromPresent = reachPoint(start, held, target, withOwn(present));
    return fromPresent.miss < fromStart.miss - better * reach ? fromPresent.q : fromStart.q;
  };

  /** The start's values, with the present values of the free hinges. */
  function withOwn(present: Float64Array): Float64Array {
    const own = q.slice();
    for (const { index } of free) own[index] = present[index]!;
    return own;
  }
}

/**
 * Where the ray meets the sphere on one side; if it misses, the nearest point of the silhouette.
 */
function onSphere(ray: Ray, center: vec3, radius: number, isFar: boolean): vec3 {
  const span = sphereSpan(ray, center, radius);
  // From within the sphere, only the far side is ahead.
  if (span && span[1] >= 0) return pointOnRay(ray, isFar || span[0] < 0 ? span[1] : span[0]);
  const offset = vec3.subtract(new Float64Array(3), center, ray.origin);
  const closest = pointOnRay(ray, Math.max(0, vec3.dot(offset, ray.direction)));
  const out = vec3.subtract(closest, closest, center);
  return vec3.scaleAndAdd(new Float64Array(3), center, vec3.normalize(out, out), radius);
}
