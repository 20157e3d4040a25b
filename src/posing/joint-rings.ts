import type { mat4 } from 'gl-matrix';
import { type ReadonlyMat4, type ReadonlyVec3, vec3 } from 'gl-matrix';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import { type DofFrame, jointFrames } from './joint-frames.ts';

/**
 * A ring about an axis of a joint, by which one of its angles is dragged. Vectors are in the
 * character's space.
 */
export interface JointRing {
  /** The index of its value in q; for an axis of a ball, where the ball's four values start. */
  readonly index: number;
  /** Which of a ball's own axes it is about; absent for a hinge. */
  readonly ballAxis?: 0 | 1 | 2;
  /** The coordinate axis that is nearest to its own in the joint's frame, for its color. */
  readonly axis: 0 | 1 | 2;
  readonly center: vec3;
  /** Unit vector along the axis; a positive turn is counterclockwise seen from its tip. */
  readonly normal: vec3;
  /** Unit vector from the center to where the ring marks the present value; toward the limb. */
  readonly mark: vec3;
  /** Radians from the present value to its limits, which may be infinite; the first is negative. */
  readonly range: readonly [number, number];
}

/** A limb that is nearer to an axis than this (a sine) does not show how it is turned. */
const alongAxis = 0.1;

const coordinates = [0, 1, 2] as const;

/**
 * Returns a ring for each hinge of a joint that is not locked, about its axis as it stands in the
 * pose, and three rings about a ball's own axes.
 *
 * @param limb from the joint to the end of its limb, in the joint's frame, or null
 */
export function jointRings(
  skeleton: Skeleton,
  joint: number,
  q: Float64Array,
  characterFromParent: ReadonlyMat4,
  limb: ReadonlyVec3 | null,
): JointRing[] {
  const { qMin, qMax, dofAxis, dofStart } = skeleton;
  const frames = jointFrames(skeleton, joint, q, characterFromParent);
  const toLimb = limb && rotated(frames.characterFromJoint, limb);
  return frames.dofs.flatMap((dof, i): JointRing[] => {
    const after = frames.dofs[i + 1]?.worldFromDof ?? frames.characterFromJoint;
    const ring = ({ index, origin }: DofFrame, normal: vec3, axis: 0 | 1 | 2) => ({
      ...{ index, axis, normal, center: origin },
      mark: markOf(normal, toLimb, rotated(after, unitVector((axis + 1) % 3))),
    });
    if (dof.kind === DofKind.ball) {
      return coordinates.map((axis) => ({
        ...ring(dof, rotated(after, unitVector(axis)), axis),
        ballAxis: axis,
        range: [-Infinity, Infinity],
      }));
    }
    const [least, most, value] = [qMin[dof.index]!, qMax[dof.index]!, q[dof.index]!];
    if (dof.kind !== DofKind.hinge || least === most) return [];
    const at = (dofStart[joint]! + i) * 3;
    const axis = mainAxis(dofAxis.subarray(at, at + 3));
    return [{ ...ring(dof, dof.axis, axis), range: [least - value, most - value] }];
  });
}

/** The part of the limb's direction across the axis, or else that of a direction that turns too. */
function markOf(normal: vec3, limb: vec3 | null, other: vec3): vec3 {
  const toward = limb && across(limb, normal);
  const isClear = toward && vec3.length(toward) > alongAxis * vec3.length(limb);
  const chosen = isClear ? toward : across(other, normal);
  return vec3.normalize(chosen, chosen);
}

function across(vector: vec3, normal: vec3): vec3 {
  const along = vec3.dot(vector, normal);
  return vec3.scaleAndAdd(new Float64Array(3), vector, normal, -along);
}

function mainAxis(axis: Float64Array): 0 | 1 | 2 {
  const sizes = coordinates.map((i) => Math.abs(axis[i]!));
  return coordinates[sizes.indexOf(Math.max(...sizes))]!;
}

function unitVector(axis: number): vec3 {
  return coordinates.map((i) => (i === axis ? 1 : 0));
}

function rotated(matrix: mat4, vector: ReadonlyVec3): vec3 {
  const tip = vec3.transformMat4(new Float64Array(3), vector, matrix);
  return vec3.subtract(tip, tip, [matrix[12], matrix[13], matrix[14]]);
}
