import { inverse, type Matrix, multiply, transpose, type Vector } from './matrix.ts';

/** A quaternion w x y z, as in the papers. */
type Quaternion = readonly [number, number, number, number];

/** A rotation, and half the translation times the rotation. */
export type DualQuaternion = readonly [rotation: Quaternion, dual: Quaternion];

function product(a: Quaternion, b: Quaternion): Quaternion {
  const [aw, ax, ay, az] = a;
  const [bw, bx, by, bz] = b;
  return [
    aw * bw - ax * bx - ay * by - az * bz,
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by + ay * bw + az * bx - ax * bz,
    aw * bz + az * bw + ax * by - ay * bx,
  ];
}

function conjugate([w, x, y, z]: Quaternion): Quaternion {
  return [w, -x, -y, -z];
}

export function scaled(q: Quaternion, factor: number): Quaternion {
  return q.map((value) => value * factor) as unknown as Quaternion;
}

export function sum(a: Quaternion, b: Quaternion): Quaternion {
  return a.map((value, i) => value + b[i]!) as unknown as Quaternion;
}

export function inner(a: Quaternion, b: Quaternion): number {
  return a.reduce((total, value, i) => total + value * b[i]!, 0);
}

/**
 * The columns of 4 q qᵀ are q times a number, and can be read from the rotation; the longest one is
 * normalized.
 */
function quaternionOf(r: Matrix): Quaternion {
  const [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = r as [number[], number[], number[]];
  const columns = [
    [1 + xx! + yy! + zz!, zy! - yz!, xz! - zx!, yx! - xy!],
    [zy! - yz!, 1 + xx! - yy! - zz!, xy! + yx!, xz! + zx!],
    [xz! - zx!, xy! + yx!, 1 - xx! + yy! - zz!, yz! + zy!],
    [yx! - xy!, xz! + zx!, yz! + zy!, 1 - xx! - yy! + zz!],
  ];
  const [longest] = columns.toSorted((a, b) => Math.hypot(...b) - Math.hypot(...a));
  return scaled(longest as unknown as Quaternion, 1 / Math.hypot(...longest!));
}

/**
 * The affine matrix (4 × 4) as a rigid motion after a stretch (3 × 3), which is the square root of
 * LᵀL by the iteration of Denman and Beavers. L must not reflect.
 */
export function rigidAndStretch(matrix: Matrix): { motion: DualQuaternion; stretch: Matrix } {
  const linear = matrix.slice(0, 3).map((row) => row.slice(0, 3));
  const mean = (a: Matrix, b: Matrix): Matrix =>
    a.map((row, i) => row.map((value, k) => (value + b[i]![k]!) / 2));
  let root: Matrix = multiply(transpose(linear), linear);
  let other: Matrix = root.map((row, i) => row.map((_, k) => (i === k ? 1 : 0)));
  for (let i = 0; i < 30; i++) {
    [root, other] = [mean(root, inverse(other)), mean(other, inverse(root))];
  }
  const rotation = quaternionOf(multiply(linear, inverse(root)));
  const translation: Quaternion = [0, matrix[0]![3]!, matrix[1]![3]!, matrix[2]![3]!];
  return { motion: [rotation, scaled(product(translation, rotation), 0.5)], stretch: root };
}

/** c p c* + 2 e c*, of which the vector part counts. */
export function moved([c, e]: DualQuaternion, [x, y, z]: Vector): number[] {
  const turned = product(product(c, [0, x!, y!, z!]), conjugate(c));
  return sum(turned, scaled(product(e, conjugate(c)), 2)).slice(1);
}
