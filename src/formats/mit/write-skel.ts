import { jointMatrices } from '../../core/forward-kinematics.ts';
import { DofKind, noParent, type Skeleton } from '../../core/skeleton.ts';
import { encodeLines, writeFloat64 } from '../text/write-number.ts';

/**
 * Writes joints in file order. The format has no rest rotations: if any joint is rotated at rest,
 * all joints keep their positions, and their axes become the world's.
 */
export function writeSkel(skeleton: Skeleton): Uint8Array {
  const joints = [...skeleton.jointOfSource];
  const turned = joints.some((joint) => standsTurned(skeleton, joint));
  const offsets = turned ? worldOffsets(skeleton) : skeleton.restOffsets;
  const lines = joints.map((joint) => {
    const offset = offsets.subarray(joint * 3, joint * 3 + 3);
    return [...Array.from(offset, writeFloat64), parentInFile(skeleton, joint)].join(' ');
  });
  return encodeLines(lines);
}

export function parentInFile({ parents, sourceIndex }: Skeleton, joint: number): number {
  const parent = parents[joint]!;
  return parent === noParent ? noParent : sourceIndex[parent]!;
}

/** Whether a joint's rest is more than an offset: it is rotated, or posed by the file. */
export function standsTurned(skeleton: Skeleton, joint: number): boolean {
  const { restRotations, dofStart, dofQ, qRest } = skeleton;
  // The value of slides and hinges, and x, y and z of rotations: all are zero if nothing is
  // rotated.
  const values = [...restRotations.subarray(joint * 4, joint * 4 + 3)];
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    const isBall = skeleton.dofKind[dof] === DofKind.ball;
    values.push(...qRest.subarray(dofQ[dof], dofQ[dof]! + (isBall ? 3 : 1)));
  }
  return values.some((value) => value !== 0);
}

/** (jointCount × 3) from each parent's position to the joint's at rest, along the world's axes. */
function worldOffsets(skeleton: Skeleton): Float64Array {
  const characterFromJoint = jointMatrices(skeleton, skeleton.qRest);
  return skeleton.restOffsets.map((_, i) => {
    const [joint, axis] = [Math.floor(i / 3), i % 3];
    const parent = skeleton.parents[joint]!;
    const start = parent === noParent ? 0 : characterFromJoint[parent * 16 + 12 + axis]!;
    return characterFromJoint[joint * 16 + 12 + axis]! - start;
  });
}
