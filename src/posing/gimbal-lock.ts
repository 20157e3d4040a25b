import { vec3 } from 'gl-matrix';
import { DofKind, type Skeleton } from '../core/skeleton.ts';

/** How near the middle angle is to a right angle where the lock counts; in radians. */
const gimbalReach = (5 * Math.PI) / 180;
/** How far the axes of three hinges may be from a right angle, as a cosine. */
const square = 1e-9;

/**
 * Whether the outer and the inner hinge of a joint turn about nearly one axis: of three hinges at
 * right angles, R = R₁ · R₂ · R₃, the middle angle is within `gimbalReach` of ±90°. Then one
 * direction of turning is missing, whatever the two others do.
 *
 * @returns the indices of the two values in q, the outer one first, or null
 */
export function gimbalLock(
  { dofStart, dofKind, dofAxis, dofQ, qMin, qMax }: Skeleton,
  joint: number,
  q: Float64Array,
): readonly [number, number] | null {
  const turning: number[] = [];
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    if (dofKind[dof] === DofKind.ball) return null;
    if (dofKind[dof] === DofKind.hinge) turning.push(dof);
  }
  const [outer, middle, inner] = turning;
  if (outer === undefined || middle === undefined || inner === undefined) return null;
  const axisOf = (dof: number): Float64Array => dofAxis.subarray(dof * 3, dof * 3 + 3);
  const cosines = [
    vec3.dot(axisOf(outer), axisOf(middle)),
    vec3.dot(axisOf(middle), axisOf(inner)),
    vec3.dot(axisOf(inner), axisOf(outer)),
  ];
  if (turning.length > 3 || cosines.some((cosine) => Math.abs(cosine) > square)) return null;
  // A hinge that is locked by its limits has no direction to lose.
  const [first, last] = [dofQ[outer]!, dofQ[inner]!];
  if ([first, last].some((index) => qMin[index] === qMax[index])) return null;
  return isLockedAt(q[dofQ[middle]!]!) ? [first, last] : null;
}

/** Whether the middle one of three angles is within `gimbalReach` of ±90°, up to full turns. */
export function isLockedAt(middle: number): boolean {
  return Math.abs(Math.cos(middle)) <= Math.sin(gimbalReach);
}
