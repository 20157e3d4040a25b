import { quat, type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { Skeleton } from '../core/skeleton.ts';
import type { JointRing } from './joint-rings.ts';

/** Pixels of the picture, x to the right and y up. */
export type Pixels = readonly [x: number, y: number];

/** A ring as the picture shows it: an ellipse. */
export interface SeenRing {
  readonly center: Pixels;
  /** From the center to a point of the ring, and to the one a quarter turn counterclockwise. */
  readonly first: Pixels;
  readonly second: Pixels;
  /** The angle from `first` at which the ring is nearest to the viewer. */
  readonly nearest: number;
}

/** A ring in space: its center, and from there two points of it a quarter turn apart. */
export interface RingPlace {
  readonly center: ReadonlyVec3;
  readonly first: ReadonlyVec3;
  readonly second: ReadonlyVec3;
}

const fullTurn = 2 * Math.PI;
/** An ellipse that is narrower than this part of its length is seen edge-on. */
const edgeOn = 0.2;

/**
 * @param eye the viewer's place
 * @param pixelsOf where the picture shows a point
 */
export function seenRing(
  { center, first, second }: RingPlace,
  eye: ReadonlyVec3,
  pixelsOf: (point: ReadonlyVec3) => Pixels,
): SeenRing {
  const toEye = vec3.subtract(new Float64Array(3), eye, center);
  const half = (vector: ReadonlyVec3): Pixels => {
    const [from, to] = [-1, 1].map((sign) =>
      pixelsOf(vec3.scaleAndAdd(new Float64Array(3), center, vector, sign)),
    );
    return [(to![0] - from![0]) / 2, (to![1] - from![1]) / 2];
  };
  return {
    center: pixelsOf(center),
    first: half(first),
    second: half(second),
    nearest: Math.atan2(vec3.dot(second, toEye), vec3.dot(first, toEye)),
  };
}

/**
 * Returns the angle by which a ring turns when the pointer moves: that of the ring's points under
 * the pointer, whatever their distance from the center. A ring that is seen edge-on rolls like a
 * wheel under the hand: its near side moves with the pointer.
 *
 * @param near of the angles that differ by full turns, the nearest to this one is returned
 */
export function ringTurn(ring: SeenRing, from: Pixels, to: Pixels, near = 0): number {
  if (to[0] === from[0] && to[1] === from[1] && near === 0) return 0;
  if (isEdgeOn(ring)) return rollingTurn(ring, from, to);
  const turn = angleAt(ring, to) - angleAt(ring, from);
  return turn + fullTurn * Math.round((near - turn) / fullTurn);
}

/**
 * Returns the turn nearest to `turn` that brings a hinge's value to a multiple of `step`, or, where
 * there is no one value, is a multiple itself. A step of 0 changes nothing.
 */
export function snappedTurn(value: number | null, turn: number, step: number): number {
  if (step === 0) return turn;
  const from = value ?? 0;
  return Math.round((from + turn) / step) * step - from;
}

/**
 * Returns the pose in which a ring has turned by an angle, within its limits. Only the ring's own
 * value or ball changes.
 */
export function turnRing(
  { qMin, qMax }: Skeleton,
  q: Float64Array,
  { index, ballAxis }: Pick<JointRing, 'index' | 'ballAxis'>,
  angle: number,
): Float64Array {
  const next = q.slice();
  if (ballAxis === undefined) {
    next[index] = Math.min(Math.max(q[index]! + angle, qMin[index]!), qMax[index]!);
    return next;
  }
  // Without a turn, normalizing again would change the last bits.
  if (angle === 0) return next;
  const own = next.subarray(index, index + 4);
  const axis = [0, 1, 2].map((i) => (i === ballAxis ? 1 : 0)) as [number, number, number];
  const about = quat.setAxisAngle(new Float64Array(4), axis, angle);
  const before = own.slice();
  quat.normalize(own, quat.multiply(own, before, about));
  // The two quaternions of a rotation are equal; the nearer one keeps the angles steady.
  if (quat.dot(own, before) < 0) quat.scale(own, own, -1);
  return next;
}

/** The angle on the ellipse, from `first`, of the ray from the center through a place. */
function angleAt({ center, first, second }: SeenRing, [x, y]: Pixels): number {
  const [dx, dy] = [x - center[0], y - center[1]];
  // The place is center + a · first + b · second; the sign of the area tells which side is seen.
  const area = cross(first, second);
  return Math.atan2(cross(first, [dx, dy]) / area, cross([dx, dy], second) / area);
}

function isEdgeOn({ first, second }: SeenRing): boolean {
  const area = Math.abs(cross(first, second));
  const size = first[0] ** 2 + first[1] ** 2 + second[0] ** 2 + second[1] ** 2;
  // The ellipse's half axes a and b have a · b = area and a² + b² = size.
  const longSquared = (size + Math.sqrt(Math.max(0, size * size - 4 * area * area))) / 2;
  return area < edgeOn * longSquared;
}

function rollingTurn({ first, second, nearest }: SeenRing, from: Pixels, to: Pixels): number {
  const [sin, cos] = [Math.sin(nearest), Math.cos(nearest)];
  // How the nearest point moves, in pixels per radian.
  const [x, y] = [second[0] * cos - first[0] * sin, second[1] * cos - first[1] * sin];
  const squared = x * x + y * y;
  return squared > 0 ? ((to[0] - from[0]) * x + (to[1] - from[1]) * y) / squared : 0;
}

function cross(a: Pixels, b: Pixels): number {
  return a[0] * b[1] - a[1] * b[0];
}
