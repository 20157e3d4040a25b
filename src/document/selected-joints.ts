import type { Session } from './session.ts';

/** What says which joints of the selected actor are selected. */
export type JointSelection = Pick<Session, 'selectedJoint' | 'jointGroup'>;

/** The joints that are selected together, the one whose rings and numbers are shown first. */
export function selectedJoints({ selectedJoint, jointGroup }: JointSelection): readonly number[] {
  const joint = selectedJoint.value;
  if (joint === null) return [];
  // Whatever else selects a joint narrows the selection to it, without having to know of groups.
  return jointGroup.value[0] === joint ? jointGroup.value : [joint];
}
