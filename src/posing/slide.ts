import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import { pointOnRay, type Ray } from '../core/ray.ts';

/** Below this sine a ray counts as parallel to a line or a plane. */
const parallel = 1e-3;

/**
 * Returns how far a handle slides along a line when the pointer's ray changes: from the point of
 * the line that is nearest to the first ray to that of the second. (Ericson 2005, 5.1.8.)
 *
 * @param direction unit vector of the line through `origin`
 * @returns null if a ray is parallel to the line, or meets it only behind the eye
 */
export function slideOnLine(
  origin: ReadonlyVec3,
  direction: ReadonlyVec3,
  from: Ray,
  to: Ray,
): number | null {
  const [start, end] = [from, to].map((ray) => placeOnLine(origin, direction, ray));
  return start === null || end === null ? null : end! - start!;
}

/**
 * Returns the vector by which a handle slides on a plane when the pointer's ray changes.
 *
 * @param normal unit vector across the plane through `origin`
 * @returns null if a ray is parallel to the plane, or meets it only behind the eye
 */
export function slideOnPlane(
  origin: ReadonlyVec3,
  normal: ReadonlyVec3,
  from: Ray,
  to: Ray,
): vec3 | null {
  const [start, end] = [from, to].map((ray) => placeOnPlane(origin, normal, ray));
  return start && end ? vec3.subtract(new Float64Array(3), end, start) : null;
}

function placeOnLine(origin: ReadonlyVec3, direction: ReadonlyVec3, ray: Ray): number | null {
  const cosine = vec3.dot(direction, ray.direction);
  const sineSquared = 1 - cosine * cosine;
  if (sineSquared < parallel * parallel) return null;
  const offset = vec3.subtract(new Float64Array(3), ray.origin, origin);
  const [along, ahead] = [vec3.dot(direction, offset), vec3.dot(ray.direction, offset)];
  if (cosine * along - ahead < 0) return null;
  return (along - cosine * ahead) / sineSquared;
}

function placeOnPlane(origin: ReadonlyVec3, normal: ReadonlyVec3, ray: Ray): vec3 | null {
  const sine = vec3.dot(normal, ray.direction);
  if (Math.abs(sine) < parallel) return null;
  const offset = vec3.subtract(new Float64Array(3), origin, ray.origin);
  const distance = vec3.dot(normal, offset) / sine;
  return distance < 0 ? null : pointOnRay(ray, distance);
}
