import { type EulerProduct, extractEuler } from '../core/euler.ts';

/** Unit quaternion xyzw, float64. */
export type Quaternion = readonly [x: number, y: number, z: number, w: number];

/** The rotation of hinges and balls, in stored order. Slides turn nothing. */
export function rotationOf(dofs: string, values: ArrayLike<number>): Quaternion {
  let rotation: Quaternion = [0, 0, 0, 1];
  let at = 0;
  for (const letter of dofs) {
    if (letter === 'Q') {
      const ball: Quaternion = [values[at]!, values[at + 1]!, values[at + 2]!, values[at + 3]!];
      rotation = product(rotation, ball);
      at += 4;
      continue;
    }
    const axis = 'XYZ'.indexOf(letter);
    if (axis >= 0) rotation = product(rotation, aboutAxis(axis, values[at]!));
    at++;
  }
  return rotation;
}

/** The products whose angles can be extracted, by the letters of their hinges. */
const products: Readonly<Record<string, EulerProduct>> = { XYZ: 'xyz', ZYX: 'zyx' };

/** Whether hinges are three about the coordinate axes whose angles can be extracted. */
export function isTriple(hinges: string): boolean {
  return hinges in products;
}

/**
 * Returns the angles of a triple of hinges that turn as a rotation does, in stored order. Of the
 * equivalent ones those nearest to `near` are taken.
 *
 * @param near angles in stored order
 */
export function tripleAnglesOf(
  hinges: string,
  rotation: Quaternion,
  near: ArrayLike<number>,
): readonly [number, number, number] {
  const order = products[hinges]!;
  const sorted = (triple: ArrayLike<number>): [number, number, number] =>
    order === 'xyz' ? [triple[0]!, triple[1]!, triple[2]!] : [triple[2]!, triple[1]!, triple[0]!];
  return sorted(extractEuler(matrixOf(rotation), order, sorted(near)));
}

/**
 * The rotation at a fraction of the shorter way between two (Shoemake 1985, "Animating rotation
 * with quaternion curves"). The angle from the first grows in proportion to the fraction.
 */
export function slerp(from: Quaternion, to: Quaternion, fraction: number): Quaternion {
  const dot = from[0] * to[0] + from[1] * to[1] + from[2] * to[2] + from[3] * to[3];
  const sign = dot < 0 ? -1 : 1;
  const sum = Math.hypot(...from.map((value, i) => value + sign * to[i]!));
  const difference = Math.hypot(...from.map((value, i) => value - sign * to[i]!));
  // Unlike the arc cosine of their product, this is exact where they are nearly equal.
  const angle = 2 * Math.atan2(difference, sum);
  const sine = Math.sin(angle);
  const [u, v] =
    sine < 1e-9
      ? [1 - fraction, fraction]
      : [Math.sin((1 - fraction) * angle) / sine, Math.sin(fraction * angle) / sine];
  const mixed = from.map((value, i) => u * value + v * sign * to[i]!);
  const length = Math.hypot(...mixed);
  return [mixed[0]! / length, mixed[1]! / length, mixed[2]! / length, mixed[3]! / length];
}

function aboutAxis(axis: number, angle: number): Quaternion {
  const sine = Math.sin(angle / 2);
  const part = (each: number): number => (each === axis ? sine : 0);
  return [part(0), part(1), part(2), Math.cos(angle / 2)];
}

function product(a: Quaternion, b: Quaternion): Quaternion {
  const [ax, ay, az, aw] = a;
  const [bx, by, bz, bw] = b;
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by + ay * bw + az * bx - ax * bz,
    aw * bz + az * bw + ax * by - ay * bx,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

/** The first eleven elements of the column-major 4 × 4 matrix. */
function matrixOf([x, y, z, w]: Quaternion): number[] {
  return [
    ...[1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0],
    ...[2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0],
    ...[2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
  ];
}
