import { vec3 } from 'gl-matrix';
import { pointOnRay, type Ray, sphereSpan } from '../core/ray.ts';
import { withinLimits } from './joint-frames.ts';
import { reachPoint } from './reach-point.ts';
import { nearestValue } from './single-value.ts';
import { shortestTurn, turnFreely, type TurnStart } from './turn-joint.ts';

/** What a better solution from elsewhere must save, as a part of the reach, to be taken. */
const better = 1e-3;

/**
 * Turns a joint so that a point of it follows a ray, always from the start. The point can be anywhere
 * on the sphere about where the joint turns: it goes to where the ray meets the sphere, on the side,
 * near or far, on which it began; past the rim to the rim.
 *
 * A ball, or three hinges, take the shortest turn there. Where limits stop that, and where there are
 * but two hinges, it comes as near as they let it; a single hinge goes nearest to the ray.
 *
 * @param grabbed at the start, character space; `held` is the same in the joint's frame
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
    // Two hinges have single solutions: the present ones may lie in another valley, and be better.
    const fromPresent = reachPoint(start, held, target, withOwn(present));
    return fromPresent.miss < fromStart.miss - better * reach ? fromPresent.q : fromStart.q;
  };

  /** The start's values, but the free hinges' of the present. */
  function withOwn(present: Float64Array): Float64Array {
    const own = q.slice();
    for (const { index } of free) own[index] = present[index]!;
    return own;
  }
}

/** Where the ray meets the sphere on one side; where it does not, the rim's point nearest to it. */
function onSphere(ray: Ray, center: vec3, radius: number, isFar: boolean): vec3 {
  const span = sphereSpan(ray, center, radius);
  // From within the sphere only the far side is ahead.
  if (span && span[1] >= 0) return pointOnRay(ray, isFar || span[0] < 0 ? span[1] : span[0]);
  const offset = vec3.subtract(new Float64Array(3), center, ray.origin);
  const closest = pointOnRay(ray, Math.max(0, vec3.dot(offset, ray.direction)));
  const out = vec3.subtract(closest, closest, center);
  return vec3.scaleAndAdd(new Float64Array(3), center, vec3.normalize(out, out), radius);
}
