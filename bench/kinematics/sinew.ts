import { forwardKinematics } from '../../src/core/forward-kinematics.ts';
import { characterFromJoints, type Joint } from '../../tests/reference/kinematics.ts';
import type { JointTree } from '../data/joint-tree.ts';
import { expectRight } from '../harness/group.ts';

/** Writes the matrices of all joints for angles, which are copied inside the clock. */
export interface Kinematics {
  readonly run: (angles: Float64Array) => void;
  /** (jointCount × 16) column-major. */
  readonly matrices: () => Float64Array;
}

export function sinewKinematics({ skeleton }: JointTree): Kinematics {
  const q = skeleton.qRest.slice();
  const characterFromJoint = new Float64Array(skeleton.jointCount * 16);
  return {
    run(angles) {
      q.set(angles);
      forwardKinematics(skeleton, q, characterFromJoint);
    },
    matrices: () => characterFromJoint,
  };
}

const axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** Checks all matrices against the float64 oracle of the tests. */
export function checkKinematics(
  id: string,
  program: Kinematics,
  { parents, offsets }: JointTree,
  angles: Float64Array,
): void {
  const joints = parents.map((parent, index): Joint => ({
    parent,
    offset: [...offsets.subarray(index * 3, index * 3 + 3)],
    rotation: [0, 0, 0, 1],
    freedoms: axes.map((axis) => ({ kind: 'hinge', axis })),
  }));
  const values = joints.map((_, index) => [0, 1, 2].map((axis) => [angles[index * 3 + axis]!]));
  const wanted = characterFromJoints(joints, values);
  program.run(angles);
  const found = program.matrices();
  wanted.forEach((matrix, joint) => {
    for (let i = 0; i < 16; i++) {
      const difference = Math.abs(found[joint * 16 + i]! - matrix[i % 4]![Math.floor(i / 4)]!);
      expectRight(difference < 1e-9, `${id}, joint ${joint} differs by ${difference}`);
    }
  });
}
