import type { Skin } from '../core/skin.ts';

/**
 * The inverse bind matrix of every palette entry as `rigidFromBind · stretch`. Joints move rigidly,
 * so that `characterFromJoint · rigidFromBind` is a rigid motion.
 */
export interface BindFactors {
  /** (entryCount × 16) column-major: a rotation with a translation. */
  readonly rigidFromBind: Float64Array;
  /** (entryCount × 9) row by row: scale, shear and reflection; null if no entry has any. */
  readonly stretch: Float64Array | null;
}

/** How far `LᵀL` may be from the identity if `L` is to count as a rotation, per element. */
const roundingOfFiles = 1e-6;

const known = new WeakMap<Float64Array, BindFactors>();

/** Returns the factors of a skin's inverse bind matrices; they are computed once. */
export function bindFactors({ jointFromBind }: Pick<Skin, 'jointFromBind'>): BindFactors {
  let factors = known.get(jointFromBind);
  if (!factors) known.set(jointFromBind, (factors = factor(jointFromBind)));
  return factors;
}

function factor(jointFromBind: Float64Array): BindFactors {
  const entryCount = jointFromBind.length / 16;
  const linear = Array.from({ length: entryCount }, (_, entry) => upperRows(jointFromBind, entry));
  if (linear.every(isRotation)) return { rigidFromBind: jointFromBind, stretch: null };
  const rigidFromBind = jointFromBind.slice();
  const stretch = new Float64Array(entryCount * 9);
  linear.forEach((matrix, entry) => {
    const rotation = isRotation(matrix) ? matrix : nearestRotation(matrix);
    stretch.set(isRotation(matrix) ? identity : product(transpose(rotation), matrix), entry * 9);
    for (let row = 0; row < 3; row++) {
      for (let column = 0; column < 3; column++) {
        rigidFromBind[entry * 16 + column * 4 + row] = rotation[row * 3 + column]!;
      }
    }
  });
  return { rigidFromBind, stretch };
}

/** A 3 × 3 matrix, row by row. */
type Matrix = readonly number[];

const identity: Matrix = [1, 0, 0, 0, 1, 0, 0, 0, 1];

function upperRows(matrices: Float64Array, entry: number): Matrix {
  return identity.map((_, i) => matrices[entry * 16 + (i % 3) * 4 + Math.floor(i / 3)]!);
}

function isRotation(matrix: Matrix): boolean {
  const squared = product(transpose(matrix), matrix);
  const isRound = squared.every((value, i) => Math.abs(value - identity[i]!) < roundingOfFiles);
  return isRound && determinant(matrix) > 0;
}

/**
 * The rotation of the polar decomposition, by Newton's iteration (Higham 1986, "Computing the polar
 * decomposition"). A reflection goes to the stretch, and a matrix without an inverse is all stretch.
 */
function nearestRotation(matrix: Matrix): Matrix {
  const size = Math.hypot(...matrix);
  let next = matrix.map((value) => value / (size || 1));
  if (!(Math.abs(determinant(next)) > 1e-12)) return identity;
  for (let change = 1, i = 0; change > 1e-15 && i < 100; i++) {
    const former = next;
    const scale = 1 / determinant(former);
    next = cofactors(former).map((value, at) => 0.5 * (former[at]! + scale * value));
    change = Math.max(...next.map((value, at) => Math.abs(value - former[at]!)));
  }
  return determinant(next) < 0 ? next.map((value) => -value) : next;
}

function transpose(m: Matrix): Matrix {
  return m.map((_, i) => m[(i % 3) * 3 + Math.floor(i / 3)]!);
}

function product(a: Matrix, b: Matrix): Matrix {
  return identity.map((_, i) => {
    const row = i - (i % 3);
    return a[row]! * b[i % 3]! + a[row + 1]! * b[3 + (i % 3)]! + a[row + 2]! * b[6 + (i % 3)]!;
  });
}

function cofactors(m: Matrix): Matrix {
  return m.map((_, i) => {
    const [r1, r2] = [((Math.floor(i / 3) + 1) % 3) * 3, ((Math.floor(i / 3) + 2) % 3) * 3];
    const [c1, c2] = [(i + 1) % 3, (i + 2) % 3];
    return m[r1 + c1]! * m[r2 + c2]! - m[r1 + c2]! * m[r2 + c1]!;
  });
}

function determinant(m: Matrix): number {
  const [x, y, z] = cofactors(m);
  return m[0]! * x! + m[1]! * y! + m[2]! * z!;
}
