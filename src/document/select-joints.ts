import { batch } from '@preact/signals-core';
import { type JointSelection, selectedJoints } from './selected-joints.ts';

/** Selects one joint alone, or none. */
export function selectJoint({ selectedJoint, jointGroup }: JointSelection, joint: number | null) {
  batch(() => {
    selectedJoint.value = joint;
    jointGroup.value = [];
  });
}

/** Selects several joints, the first of which shows its rings and numbers. */
export function selectJoints(session: JointSelection, joints: readonly number[]): void {
  batch(() => {
    session.selectedJoint.value = joints[0] ?? null;
    session.jointGroup.value = joints;
  });
}

/** Adds a joint to the selected ones, before the others, or takes it out of them. */
export function toggleJoint(session: JointSelection, joint: number): void {
  const present = selectedJoints(session);
  const others = present.filter((each) => each !== joint);
  selectJoints(session, others.length < present.length ? others : [joint, ...present]);
}
