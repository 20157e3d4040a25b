import { batch } from '@preact/signals-core';
import type { Session } from './session.ts';

/** What says which joints of the selected actor are selected. */
type JointSelection = Pick<Session, 'selectedJoint' | 'jointGroup'>;

/** The joints that are selected together, the one whose rings and numbers are shown first. */
export function selectedJoints({ selectedJoint, jointGroup }: JointSelection): readonly number[] {
  const joint = selectedJoint.value;
  if (joint === null) return [];
  // Whatever else selects a joint narrows the selection to it, without having to know of groups.
  return jointGroup.value[0] === joint ? jointGroup.value : [joint];
}

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
