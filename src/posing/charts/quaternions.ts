import type { Quaternion } from '../../core/motion/clip-parts.ts';

// Plain functions of unit quaternions xyzw, as values.

export const noTurn: Quaternion = [0, 0, 0, 1];

/** The rotation that applies `b` first, then `a`. */
export function product(a: Quaternion, b: Quaternion): Quaternion {
  const [ax, ay, az, aw] = a;
  const [bx, by, bz, bw] = b;
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by + ay * bw + az * bx - ax * bz,
    aw * bz + az * bw + ax * by - ay * bx,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

/** @param axis unit */
export function aboutAxis(axis: readonly number[], angle: number): Quaternion {
  const sine = Math.sin(angle / 2);
  return [axis[0]! * sine, axis[1]! * sine, axis[2]! * sine, Math.cos(angle / 2)];
}

/** The rotation of a rotation vector: about its direction, by its length. */
export function exponential(vector: readonly number[]): Quaternion {
  const angle = Math.hypot(...vector);
  if (angle < 1e-12) return normalized([vector[0]! / 2, vector[1]! / 2, vector[2]! / 2, 1]);
  return aboutAxis(
    vector.map((each) => each / angle),
    angle,
  );
}

function normalized(q: Quaternion): Quaternion {
  const length = Math.hypot(...q);
  return [q[0] / length, q[1] / length, q[2] / length, q[3] / length];
}

/**
 * A vector of a given direction, or of the opposite one: of the lengths `angle` and `angle` plus
 * full turns, the one that is nearest to another vector.
 *
 * @param direction unit, or zero if the rotation is none and has no axis
 */
export function nearestShell(
  direction: readonly number[],
  angle: number,
  near: readonly number[],
): number[] {
  const length = Math.hypot(...near);
  const hasAxis = direction.some((each) => each !== 0);
  // Where the rotation is none, every axis will do: the one that came before is the nearest.
  const axis = hasAxis ? direction : near.map((each) => (length > 0 ? each / length : 0));
  const along = axis.reduce((sum, each, i) => sum + each * near[i]!, 0);
  const size = angle + fullTurn * Math.round((along - angle) / fullTurn);
  return axis.map((each) => each * size);
}

export const fullTurn = 2 * Math.PI;
