import type { Skeleton } from '../core/skeleton.ts';
import { subtreeEnd } from '../core/subtree.ts';
import { selectedJoints } from '../document/selected-joints.ts';
import type { Session } from '../document/session.ts';

/** The joints that are copied or mirrored. */
export interface ScopedJoints {
  /** Ascending. */
  readonly joints: readonly number[];
  /** Whether they are all joints, because all are meant or none is selected. */
  readonly isWhole: boolean;
  /** The name of the selected joint, where it stands for all of them; otherwise their number. */
  readonly name: string;
}

/** The joints that the scope of copying and mirroring means at present. */
export function scopedJoints(session: Session, skeleton: Skeleton): ScopedJoints {
  const selected = selectedJoints(session);
  const scope = session.poseScope.value;
  if (scope === 'whole' || selected.length === 0) {
    const joints = range(0, skeleton.jointCount);
    return { joints, isWhole: true, name: 'Pose' };
  }
  const below = (joint: number): readonly number[] =>
    scope === 'branch' ? range(joint, subtreeEnd(skeleton, joint)) : [joint];
  const joints = [...new Set(selected.flatMap(below))].sort((a, b) => a - b);
  const [first, ...others] = selected;
  const name = others.length === 0 ? skeleton.names[first!]! : `${joints.length} joints`;
  return { joints, isWhole: false, name };
}

function range(from: number, end: number): number[] {
  return Array.from({ length: end - from }, (_, i) => from + i);
}
