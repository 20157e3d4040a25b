import { mat4, type ReadonlyMat4, type ReadonlyVec3, vec3 } from 'gl-matrix';

/**
 * A half-line. `direction` has unit length, so distances along it are in the units of its space.
 */
export interface Ray {
  readonly origin: ReadonlyVec3;
  readonly direction: ReadonlyVec3;
}

/** If the squared sine is smaller, a ray is parallel to a cylinder and hits no side of it. */
const parallel = 1e-12;

export function pointOnRay({ origin, direction }: Ray, distance: number): vec3 {
  return vec3.scaleAndAdd(new Float64Array(3), origin, direction, distance);
}

/** Transforms a ray to another space; the matrix may rotate, translate and scale uniformly. */
function transformRay({ origin, direction }: Ray, matrix: ReadonlyMat4): Ray {
  const tip = vec3.add(new Float64Array(3), origin, direction);
  const moved = vec3.transformMat4(new Float64Array(3), origin, matrix);
  vec3.transformMat4(tip, tip, matrix);
  vec3.subtract(tip, tip, moved);
  return { origin: moved, direction: vec3.normalize(tip, tip) };
}

/** Transforms a ray to a frame; `worldFromFrame` must not be singular. */
export function rayInFrame(ray: Ray, worldFromFrame: ReadonlyMat4): Ray {
  const frameFromWorld = mat4.invert(new Float64Array(16), worldFromFrame);
  return frameFromWorld ? transformRay(ray, frameFromWorld) : ray;
}

/**
 * Returns where the ray's line enters and leaves a sphere, as distances from the origin (negative
 * behind it), or null if it misses.
 */
export function sphereSpan(
  { origin, direction }: Ray,
  center: ReadonlyVec3,
  radius: number,
): readonly [number, number] | null {
  const offset = vec3.subtract(new Float64Array(3), origin, center);
  const b = vec3.dot(offset, direction);
  // Computed from the line's closest point, because |offset|² - b² would lose digits for a distant
  // sphere.
  vec3.scaleAndAdd(offset, offset, direction, -b);
  const discriminant = radius * radius - vec3.dot(offset, offset);
  if (discriminant < 0) return null;
  const half = Math.sqrt(discriminant);
  return [-b - half, -b + half];
}

/** The distance at which the ray first hits a sphere's surface, or Infinity. */
export function raySphere(ray: Ray, center: ReadonlyVec3, radius: number): number {
  return firstAhead(sphereSpan(ray, center, radius), () => true);
}

/**
 * The distance at which the ray first hits the side of a cylinder about the segment `from` … `to`,
 * or Infinity. The cylinder has no caps, so a ray along its axis misses it. (CS354 "Virtual
 * Mannequin", bone picking: a line against a circle in the plane across the bone, and the position
 * along the bone from 0 to L.)
 */
export function rayCylinder(
  ray: Ray,
  from: ReadonlyVec3,
  to: ReadonlyVec3,
  radius: number,
): number {
  const axis = vec3.subtract(new Float64Array(3), to, from);
  const length = vec3.length(axis);
  if (length === 0) return Infinity;
  vec3.scale(axis, axis, 1 / length);
  const offset = vec3.subtract(new Float64Array(3), ray.origin, from);
  const [start, slope] = [vec3.dot(offset, axis), vec3.dot(ray.direction, axis)];
  // The components across the bone. They equal the second and third coordinates of its frame,
  // without choosing its axes.
  vec3.scaleAndAdd(offset, offset, axis, -start);
  const across = vec3.scaleAndAdd(new Float64Array(3), ray.direction, axis, -slope);
  const a = vec3.dot(across, across);
  if (a < parallel) return Infinity;
  const middle = -vec3.dot(offset, across) / a;
  vec3.scaleAndAdd(offset, offset, across, middle);
  const discriminant = (radius * radius - vec3.dot(offset, offset)) / a;
  if (discriminant < 0) return Infinity;
  const half = Math.sqrt(discriminant);
  return firstAhead([middle - half, middle + half], (distance) => {
    const along = start + distance * slope;
    return along >= 0 && along <= length;
  });
}

/** Like `rayCylinder`, with a half-sphere at each end, so that a bone can be hit from its ends. */
export function rayCapsule(ray: Ray, from: ReadonlyVec3, to: ReadonlyVec3, radius: number): number {
  return Math.min(
    rayCylinder(ray, from, to, radius),
    raySphere(ray, from, radius),
    raySphere(ray, to, radius),
  );
}

/**
 * The distance along the ray at which it is closest to the segment (Ericson 2005, 5.1.9); never
 * negative.
 */
export function distanceOfClosest(
  { origin, direction }: Ray,
  from: ReadonlyVec3,
  to: ReadonlyVec3,
): number {
  const axis = vec3.subtract(new Float64Array(3), to, from);
  const offset = vec3.subtract(new Float64Array(3), origin, from);
  const [a, b] = [vec3.dot(axis, axis), vec3.dot(axis, direction)];
  const [c, d] = [vec3.dot(axis, offset), vec3.dot(direction, offset)];
  const divisor = a - b * b; // the direction has unit length
  const part = divisor > parallel * a ? (c - b * d) / divisor : 0;
  return Math.max(0, Math.min(1, Math.max(0, part)) * b - d);
}

/** The distance from a point to the nearest point of a segment. */
export function distanceToSegment(
  point: ReadonlyVec3,
  from: ReadonlyVec3,
  to: ReadonlyVec3,
): number {
  const axis = vec3.subtract(new Float64Array(3), to, from);
  const offset = vec3.subtract(new Float64Array(3), point, from);
  const squared = vec3.dot(axis, axis);
  const part = squared > 0 ? vec3.dot(offset, axis) / squared : 0;
  vec3.scaleAndAdd(offset, offset, axis, -Math.min(1, Math.max(0, part)));
  return vec3.length(offset);
}

function firstAhead(
  span: readonly [number, number] | null,
  isGood: (distance: number) => boolean,
): number {
  if (!span) return Infinity;
  if (span[0] >= 0 && isGood(span[0])) return span[0];
  return span[1] >= 0 && isGood(span[1]) ? span[1] : Infinity;
}
