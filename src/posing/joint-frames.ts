import { mat4, type vec3 } from 'gl-matrix';
import { jointMatrices } from '../core/forward-kinematics.ts';
import { applyDof, applyRest } from '../core/joint-transforms.ts';
import { jointRange } from '../core/pose.ts';
import { DofKind, noParent, type Skeleton } from '../core/skeleton.ts';

/** The frame of a degree of freedom in a pose, in the character's space. */
export interface DofFrame {
  readonly kind: DofKind;
  /** The index of its first value in q. */
  readonly index: number;
  /** Column-major: the frame in which it moves, before its own transform. */
  readonly worldFromDof: mat4;
  /** Unit vector; meaningless for a ball. */
  readonly axis: vec3;
  /** A point on a hinge's axis, or the center of a ball. */
  readonly origin: vec3;
}

/** A joint with its degrees of freedom for some values of q. */
export interface JointFrames {
  /** In stored order, the outermost first. */
  readonly dofs: readonly DofFrame[];
  readonly characterFromJoint: mat4;
}

/** The matrix of a joint's parent, column-major; the identity for a root. */
export function parentMatrix(skeleton: Skeleton, joint: number, q: Float64Array): mat4 {
  const parent = skeleton.parents[joint]!;
  if (parent === noParent) return mat4.identity(new Float64Array(16));
  return jointMatrices(skeleton, q).subarray(parent * 16, parent * 16 + 16);
}

/** Visits a joint's degrees of freedom, the outermost first, as forward kinematics does. */
export function jointFrames(
  skeleton: Skeleton,
  joint: number,
  q: Float64Array,
  worldFromParent: mat4,
): JointFrames {
  const world = Float64Array.from(worldFromParent);
  applyRest(skeleton, joint, world);
  const dofs: DofFrame[] = [];
  for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
    const worldFromDof = world.slice();
    dofs.push({
      kind: skeleton.dofKind[dof] as DofKind,
      index: skeleton.dofQ[dof]!,
      worldFromDof,
      axis: rotateVector(worldFromDof, skeleton.dofAxis.subarray(dof * 3, dof * 3 + 3)),
      origin: worldFromDof.slice(12, 15),
    });
    applyDof(skeleton, dof, q, world);
  }
  return { dofs, characterFromJoint: world };
}

/** The hinges of a joint that are not locked by their limits. */
export function freeHinges({ qMin, qMax }: Skeleton, { dofs }: JointFrames): DofFrame[] {
  return dofs.filter(({ kind, index }) => kind === DofKind.hinge && qMin[index]! < qMax[index]!);
}

/**
 * Whether a drag can rotate the joint: it has a ball, or a hinge that is not locked by its limits.
 */
export function canTurn(skeleton: Skeleton, joint: number): boolean {
  for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
    if (skeleton.dofKind[dof] === DofKind.ball) return true;
    const index = skeleton.dofQ[dof]!;
    const isFree = skeleton.qMin[index]! < skeleton.qMax[index]!;
    if (skeleton.dofKind[dof] === DofKind.hinge && isFree) return true;
  }
  return false;
}

/** Returns a copy of q with the joint's values clamped to their limits. */
export function withinLimits(skeleton: Skeleton, joint: number, q: Float64Array): Float64Array {
  const [from, to] = jointRange(skeleton, joint);
  const clamped = q.slice();
  for (let i = from; i < to; i++) {
    clamped[i] = Math.min(Math.max(q[i]!, skeleton.qMin[i]!), skeleton.qMax[i]!);
  }
  return clamped;
}

function rotateVector(m: mat4, v: ArrayLike<number>): vec3 {
  const out = new Float64Array(3);
  for (let row = 0; row < 3; row++) {
    out[row] = m[row]! * v[0]! + m[4 + row]! * v[1]! + m[8 + row]! * v[2]!;
  }
  return out;
}
