import { mat3, type quat, vec3 } from 'gl-matrix';
import { extractEuler } from '../core/euler.ts';
import { DofKind } from '../core/skeleton.ts';
import type { DofFrame, JointFrames } from './joint-frames.ts';

/** How far the axes of a triple may be from a right angle, as a cosine. */
const square = 1e-9;

/** Three consecutive hinges about axes at right angles; they can reach any rotation. */
export interface HingeTriple {
  readonly hinges: readonly [DofFrame, DofFrame, DofFrame];
  /** In world space: the columns are the axes before the triple's rotation. */
  readonly axesBefore: mat3;
  readonly axesAfter: mat3;
  /** 1 if the axes, in their order, are right-handed (X, Y, Z), otherwise -1 (Z, Y, X). */
  readonly handedness: 1 | -1;
}

/** Returns the joint's three hinges, in any order, or null if it has no such triple. */
export function hingeTriple(
  frames: JointFrames,
  dofAxis: Float64Array,
  firstDof: number,
): HingeTriple | null {
  const { dofs } = frames;
  const first = dofs.findIndex(({ kind }) => kind !== DofKind.slide);
  const hinges = dofs.slice(first, first + 3);
  const turning = dofs.filter(({ kind }) => kind !== DofKind.slide);
  if (turning.length !== 3 || hinges.length !== 3) return null;
  if (!hinges.every(({ kind }) => kind === DofKind.hinge)) return null;
  const own = [0, 1, 2].map((i) => {
    const at = (firstDof + first + i) * 3;
    return dofAxis.subarray(at, at + 3);
  });
  const [a, b, c] = [own[0]!, own[1]!, own[2]!];
  const cosines = [vec3.dot(a, b), vec3.dot(b, c), vec3.dot(c, a)];
  if (cosines.some((cosine) => Math.abs(cosine) > square)) return null;
  const cross = vec3.cross(new Float64Array(3), a, b);
  const after = dofs[first + 3]?.worldFromDof ?? frames.characterFromJoint;
  return {
    hinges: [hinges[0]!, hinges[1]!, hinges[2]!],
    axesBefore: columnsOf(hinges[0]!.worldFromDof, own),
    axesAfter: columnsOf(after, own),
    handedness: vec3.dot(cross, c) > 0 ? 1 : -1,
  };
}

/**
 * Returns the three angles that rotate the triple by `turn` from its present state. Of the
 * equivalent ones (two triples, and full turns of each angle) those nearest to `near` are taken.
 *
 * In the frame of the axes B, the product of any three such hinges is Rx · Ry · Rz, with reversed
 * signs of the angles if B is a reflection: B (Rx · Ry · Rz) Bᵀ = R₁ · R₂ · R₃. One extraction
 * therefore covers all orders.
 *
 * @param turn unit quaternion xyzw, world space
 * @param near the present q, of which the hinges' values are used
 */
export function tripleAngles(triple: HingeTriple, turn: quat, near: Float64Array): number[] {
  const { hinges, axesBefore, axesAfter, handedness } = triple;
  const product = mat3.fromQuat(new Float64Array(9), turn);
  mat3.multiply(product, product, axesAfter);
  const before = mat3.transpose(new Float64Array(9), axesBefore);
  mat3.multiply(product, before, product);
  const [m0, m1, m2, m3, m4, m5, m6, m7, m8] = product;
  const rotation = [m0!, m1!, m2!, 0, m3!, m4!, m5!, 0, m6!, m7!, m8!];
  const from = hinges.map(({ index }) => handedness * near[index]!);
  return extractEuler(rotation, 'xyz', from).map((angle) => handedness * angle);
}

/** 3 × 3, column-major: the vectors, rotated by the matrix's rotation. */
function columnsOf(matrix: ArrayLike<number>, vectors: readonly Float64Array[]): mat3 {
  const rotation = mat3.fromMat4(new Float64Array(9), matrix as Float64Array);
  const columns = Float64Array.from(vectors.flatMap((vector) => [...vector]));
  return mat3.multiply(columns, rotation, columns);
}
