import { axisDofs, type Pose } from '../core/pose.ts';
import { DofKind, firstRoot, type Skeleton } from '../core/skeleton.ts';
import { ballValue, type BallJson, type Quaternion, type Triple } from './ball-values.ts';
import type { PoseJson } from './pose-json.ts';

/** Returns the pose as JSON, with only the joints that differ from the file's pose, by name. */
export function poseToJson(skeleton: Skeleton, pose: Pose): PoseJson {
  const joints: [string, BallJson][] = [];
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const values =
      ballValues(skeleton, pose, joint) ?? axisValues(skeleton, pose, joint, DofKind.hinge);
    if (values) joints.push([skeleton.names[joint]!, values]);
  }
  const root = firstRoot(skeleton);
  const displacement = root >= 0 && axisValues(skeleton, pose, root, DofKind.slide);
  // Built from entries, because a joint may have any name, even "__proto__".
  return { joints: Object.fromEntries(joints), ...(displacement ? { root: displacement } : {}) };
}

/** The quaternion of a joint's ball; nothing if it has no ball or is as in the file. */
function ballValues(skeleton: Skeleton, { q }: Pose, joint: number): Quaternion | undefined {
  const at = ballValue(skeleton, joint);
  const values = at < 0 ? [] : [...q.subarray(at, at + 4)];
  return values.some((value, i) => value !== skeleton.qRest[at + i])
    ? (values as Quaternion)
    : undefined;
}

/** x, y, z of a joint's hinges or slides; nothing if they are as in the file. */
function axisValues(
  skeleton: Skeleton,
  pose: Pose,
  joint: number,
  kind: DofKind,
): Triple | undefined {
  const values: Triple = [0, 0, 0];
  let changed = false;
  for (const dof of axisDofs(skeleton, joint)) {
    if (dof.kind !== kind) continue;
    values[dof.axis] = pose.q[dof.index]!;
    changed ||= pose.q[dof.index] !== skeleton.qRest[dof.index];
  }
  return changed ? values : undefined;
}
