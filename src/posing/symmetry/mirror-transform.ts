import { mat3, quat, type ReadonlyMat3, vec3 } from 'gl-matrix';
import { applyDof } from '../../core/joint-transforms.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { turnJoint, turnStart } from '../turn-joint.ts';
import type { JointMirror } from './mirror-values.ts';

/** Hinges that can't take the whole rotation come nearest to it in a few turns. */
const mostTurns = 16;
/** In radians, and for slides relative to their values: what is less is not worth another turn. */
const least = 1e-14;
/** Up to this difference of their entries, two transforms count as equal. */
const near = 1e-6;

/**
 * Returns how a joint's transform since the reference, mirrored, becomes that of its partner: its
 * rotation is extracted to the degrees of freedom that the partner has, as the angles nearest to its
 * present ones, and the slides take the rest of the way. It stays within the limits.
 *
 * With the joint's transform D, and D₀ at the reference, the partner's is A D D₀⁻¹ Aᵀ D₀′, where A
 * mirrors from frame to frame.
 *
 * @param turn as `mirrorFrames` returns it for these joints
 * @param reference (qCount)
 */
export function transformMirror(
  skeleton: Skeleton,
  [joint, partner]: readonly [number, number],
  turn: ReadonlyMat3,
  reference: Float64Array,
): JointMirror {
  const before = ownTransform(skeleton, joint, reference);
  const back = mat3.transpose(new Float64Array(9), before.rotation);
  const theirs = ownTransform(skeleton, partner, reference);
  const turnBack = mat3.transpose(new Float64Array(9), turn);
  return (from, to) => {
    const own = ownTransform(skeleton, joint, from);
    const rotation = mat3.multiply(new Float64Array(9), own.rotation, back);
    mat3.multiply(rotation, turn, mat3.multiply(rotation, rotation, turnBack));
    mat3.multiply(rotation, rotation, theirs.rotation);
    const offset = vec3.subtract(new Float64Array(3), own.offset, before.offset);
    // Offsets are mirrored by the negative of what turns rotation vectors.
    vec3.subtract(offset, theirs.offset, vec3.transformMat3(offset, offset, turn));
    turnTo(skeleton, partner, rotation, to);
    slideTo(skeleton, partner, offset, to);
    const reached = ownTransform(skeleton, partner, to);
    const isTurned = reached.rotation.every((value, i) => Math.abs(value - rotation[i]!) < near);
    return isTurned && vec3.distance(reached.offset, offset) <= near * (1 + vec3.length(offset));
  };
}

/** A joint's rotation and offset by its own degrees of freedom, in the frame in which they move. */
interface OwnTransform {
  readonly rotation: Float64Array;
  readonly offset: vec3;
}

function ownTransform(skeleton: Skeleton, joint: number, q: Float64Array): OwnTransform {
  const matrix = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
    applyDof(skeleton, dof, q, matrix);
  }
  const rotation = new Float64Array(9);
  mat3.fromMat4(rotation, matrix);
  return {
    rotation,
    offset: Float64Array.from(matrix.subarray(12, 15)),
  };
}

/** Turns a joint until it has the rotation, or as near to it as its hinges and limits allow. */
function turnTo(skeleton: Skeleton, joint: number, rotation: mat3, q: Float64Array): void {
  for (let count = 0; count < mostTurns; count++) {
    const start = turnStart(skeleton, joint, q);
    const [outermost] = start.frames.dofs;
    if (!outermost) return;
    const now = mat3.transpose(new Float64Array(9), ownTransform(skeleton, joint, q).rotation);
    const rest = mat3.multiply(new Float64Array(9), rotation, now);
    const world = mat3.fromMat4(new Float64Array(9), outermost.worldFromDof);
    mat3.multiply(rest, world, rest);
    mat3.multiply(rest, rest, mat3.transpose(world, world));
    const turn = quat.normalize(new Float64Array(4), quat.fromMat3(new Float64Array(4), rest));
    if (Math.hypot(turn[0], turn[1], turn[2]) < least) return;
    const turned = turnJoint(start, turn, q);
    const moved = turned.some((value, i) => Math.abs(value - q[i]!) > least);
    q.set(turned);
    if (!moved || start.ball || start.triple) return;
  }
}

/** Sets a joint's slides so that its offset is nearest to a given one. */
function slideTo(skeleton: Skeleton, joint: number, offset: vec3, q: Float64Array): void {
  const { dofStart, dofKind, dofQ, qMin, qMax } = skeleton;
  const slides: number[] = [];
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    if (dofKind[dof] === DofKind.slide) slides.push(dofQ[dof]!);
  }
  for (let sweep = 0; sweep < mostTurns; sweep++) {
    let most = 0;
    for (const index of slides) {
      const before = q[index]!;
      const here = ownTransform(skeleton, joint, q).offset;
      q[index] = before + 1;
      const axis = vec3.subtract(
        new Float64Array(3),
        ownTransform(skeleton, joint, q).offset,
        here,
      );
      const step = vec3.dot(axis, vec3.subtract(here, offset, here));
      q[index] = Math.min(Math.max(before + step, qMin[index]!), qMax[index]!);
      most = Math.max(most, Math.abs(q[index] - before) / (1 + Math.abs(before)));
    }
    if (most < least) return;
  }
}
