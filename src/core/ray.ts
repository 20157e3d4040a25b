import { mat4, type ReadonlyMat4, type ReadonlyVec3, vec3 } from 'gl-matrix';

/** A half-line; `direction` is unit, so that distances along it are in the units of its space. */
export interface Ray {
  readonly origin: ReadonlyVec3;
  readonly direction: ReadonlyVec3;
}

/** Below this squared sine a ray runs along a cylinder and meets no side of it. */
const parallel = 1e-12;

export function pointOnRay({ origin, direction }: Ray, distance: number): vec3 {
  return vec3.scaleAndAdd(new Float64Array(3), origin, direction, distance);
}

/** The same ray in another space: the matrix may turn, move and scale evenly. */
function transformRay({ origin, direction }: Ray, matrix: ReadonlyMat4): Ray {
  const tip = vec3.add(new Float64Array(3), origin, direction);
  const moved = vec3.transformMat4(new Float64Array(3), origin, matrix);
  vec3.transformMat4(tip, tip, matrix);
  vec3.subtract(tip, tip, moved);
  return { origin: moved, direction: vec3.normalize(tip, tip) };
}

/** The same ray seen from a frame; `worldFromFrame` may not be singular. */
export function rayInFrame(ray: Ray, worldFromFrame: ReadonlyMat4): Ray {
  const frameFromWorld = mat4.invert(new Float64Array(16), worldFromFrame);
  return frameFromWorld ? transformRay(ray, frameFromWorld) : ray;
}

/**
 * Where the ray's whole line goes into and out of a sphere, as distances from its origin (negative
 * behind it); null where it passes by.
 */
export function sphereSpan(
  { origin, direction }: Ray,
  center: ReadonlyVec3,
  radius: number,
): readonly [number, number] | null {
  const offset = vec3.subtract(new Float64Array(3), origin, center);
  const b = vec3.dot(offset, direction);
  // From the line's closest point: |offset|² - b² would lose digits for a sphere far away.
  vec3.scaleAndAdd(offset, offset, direction, -b);
  const discriminant = radius * radius - vec3.squaredLength(offset);
  if (discriminant < 0) return null;
  const half = Math.sqrt(discriminant);
  return [-b - half, -b + half];
}

/** The distance at which the ray first meets a sphere's surface; Infinity where it never does. */
export function raySphere(ray: Ray, center: ReadonlyVec3, radius: number): number {
  return firstAhead(sphereSpan(ray, center, radius), () => true);
}

/**
 * The distance at which the ray first meets the side of a cylinder about the segment `from` … `to`;
 * Infinity where it never does. It has no caps: looked along, it is missed. (CS354 "Virtual
 * Mannequin", bone picking: a line against a circle in the plane across the bone, and the place
 * along it from 0 to L.)
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
  // What lies across the bone: its frame's second and third coordinates, without choosing them.
  vec3.scaleAndAdd(offset, offset, axis, -start);
  const across = vec3.scaleAndAdd(new Float64Array(3), ray.direction, axis, -slope);
  const a = vec3.squaredLength(across);
  if (a < parallel) return Infinity;
  const middle = -vec3.dot(offset, across) / a;
  vec3.scaleAndAdd(offset, offset, across, middle);
  const discriminant = (radius * radius - vec3.squaredLength(offset)) / a;
  if (discriminant < 0) return Infinity;
  const half = Math.sqrt(discriminant);
  return firstAhead([middle - half, middle + half], (distance) => {
    const along = start + distance * slope;
    return along >= 0 && along <= length;
  });
}

/** As `rayCylinder`, with a half-sphere at each end, so that a bone can be met from its ends. */
export function rayCapsule(ray: Ray, from: ReadonlyVec3, to: ReadonlyVec3, radius: number): number {
  return Math.min(
    rayCylinder(ray, from, to, radius),
    raySphere(ray, from, radius),
    raySphere(ray, to, radius),
  );
}

/** How far along the ray it is closest to the segment (Ericson 2005, 5.1.9); never behind it. */
export function distanceOfClosest(
  { origin, direction }: Ray,
  from: ReadonlyVec3,
  to: ReadonlyVec3,
): number {
  const axis = vec3.subtract(new Float64Array(3), to, from);
  const offset = vec3.subtract(new Float64Array(3), origin, from);
  const [a, b] = [vec3.dot(axis, axis), vec3.dot(axis, direction)];
  const [c, d] = [vec3.dot(axis, offset), vec3.dot(direction, offset)];
  const divisor = a - b * b; // the direction is unit
  const part = divisor > parallel * a ? (c - b * d) / divisor : 0;
  return Math.max(0, Math.min(1, Math.max(0, part)) * b - d);
}

/** From a point to the nearest of a segment. */
export function distanceToSegment(
  point: ReadonlyVec3,
  from: ReadonlyVec3,
  to: ReadonlyVec3,
): number {
  const axis = vec3.subtract(new Float64Array(3), to, from);
  const offset = vec3.subtract(new Float64Array(3), point, from);
  const squared = vec3.squaredLength(axis);
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
