import { mat4, type vec3 } from 'gl-matrix';
import { applyDof, jointMatrices, writeRestMatrix } from '../core/forward-kinematics.ts';
import { jointRange } from '../core/pose.ts';
import { DofKind, noParent, type Skeleton } from '../core/skeleton.ts';

/** A degree of freedom where it stands in a pose, in the character's space. */
export interface DofFrame {
  readonly kind: DofKind;
  /** Its first place in q. */
  readonly index: number;
  /** Column-major: the frame in which it moves, before it does. */
  readonly worldFromDof: mat4;
  /** Unit; without meaning for a ball. */
  readonly axis: vec3;
  /** A point on a hinge's axis, the center of a ball. */
  readonly origin: vec3;
}

/** A joint with its degrees of freedom at some values of q. */
export interface JointFrames {
  /** In stored order, the outermost first. */
  readonly dofs: readonly DofFrame[];
  readonly characterFromJoint: mat4;
}

/** Where a joint's parent stands; the identity for a root. Column-major. */
export function parentMatrix(skeleton: Skeleton, joint: number, q: Float64Array): mat4 {
  const parent = skeleton.parents[joint]!;
  if (parent === noParent) return mat4.identity(new Float64Array(16));
  return jointMatrices(skeleton, q).subarray(parent * 16, parent * 16 + 16);
}

/** Walks a joint's degrees of freedom, outermost first, as forward kinematics does. */
export function jointFrames(
  skeleton: Skeleton,
  joint: number,
  q: Float64Array,
  worldFromParent: mat4,
): JointFrames {
  const world: mat4 = new Float64Array(16);
  writeRestMatrix(skeleton, joint, world);
  mat4.multiply(world, worldFromParent, world);
  const dofs: DofFrame[] = [];
  for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
    const worldFromDof = mat4.copy(new Float64Array(16), world);
    dofs.push({
      kind: skeleton.dofKind[dof] as DofKind,
      index: skeleton.dofQ[dof]!,
      worldFromDof,
      axis: rotateVector(worldFromDof, skeleton.dofAxis.subarray(dof * 3, dof * 3 + 3)),
      origin: mat4.getTranslation(new Float64Array(3), worldFromDof),
    });
    applyDof(skeleton, dof, q, world);
  }
  return { dofs, characterFromJoint: world };
}

/** The hinges of a joint that limits do not lock. */
export function freeHinges({ qMin, qMax }: Skeleton, { dofs }: JointFrames): DofFrame[] {
  return dofs.filter(({ kind, index }) => kind === DofKind.hinge && qMin[index]! < qMax[index]!);
}

/** Whether a drag can turn the joint: it has a ball, or a hinge that limits do not lock. */
export function canTurn(skeleton: Skeleton, joint: number): boolean {
  for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
    if (skeleton.dofKind[dof] === DofKind.ball) return true;
    const index = skeleton.dofQ[dof]!;
    const isFree = skeleton.qMin[index]! < skeleton.qMax[index]!;
    if (skeleton.dofKind[dof] === DofKind.hinge && isFree) return true;
  }
  return false;
}

/** The values with the joint's own moved to the nearest within their limits; a new array. */
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
