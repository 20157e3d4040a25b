import { axisDofs, type Pose } from '../core/pose.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import { firstRoot } from '../core/subtree.ts';
import { ballValue, type BallJson, type Quaternion, type Triple } from './ball-values.ts';
import type { PoseJson } from './pose-json.ts';

/**
 * Returns the pose as JSON, by the names of the joints.
 *
 * @param only if given, exactly these joints are in it; otherwise those that differ from the file's
 *   pose
 */
export function poseToJson(skeleton: Skeleton, pose: Pose, only?: readonly number[]): PoseJson {
  const joints: [string, BallJson][] = [];
  const isAll = only !== undefined;
  for (const joint of only ?? skeleton.parents.keys()) {
    const values =
      ballValues(skeleton, pose, joint, isAll) ??
      axisValues(skeleton, pose, joint, DofKind.hinge, isAll);
    if (values) joints.push([skeleton.names[joint]!, values]);
  }
  const root = firstRoot(skeleton);
  const hasRoot = root >= 0 && (only?.includes(root) ?? true);
  const displacement = hasRoot && axisValues(skeleton, pose, root, DofKind.slide, isAll);
  // Built from entries, because a joint may have any name, even "__proto__".
  return { joints: Object.fromEntries(joints), ...(displacement ? { root: displacement } : {}) };
}

/**
 * The quaternion of a joint's ball; nothing if it has no ball or, unless any is wanted, if it is as
 * in the file.
 */
function ballValues(
  skeleton: Skeleton,
  { q }: Pose,
  joint: number,
  any: boolean,
): Quaternion | undefined {
  const at = ballValue(skeleton, joint);
  const values = at < 0 ? [] : [...q.subarray(at, at + 4)];
  return values.some((value, i) => any || value !== skeleton.qRest[at + i])
    ? (values as Quaternion)
    : undefined;
}

/**
 * x, y, z of a joint's hinges or slides; nothing if it has none or, unless any are wanted, if they
 * are as in the file.
 */
function axisValues(
  skeleton: Skeleton,
  pose: Pose,
  joint: number,
  kind: DofKind,
  any: boolean,
): Triple | undefined {
  const values: Triple = [0, 0, 0];
  let changed = false;
  for (const dof of axisDofs(skeleton, joint)) {
    if (dof.kind !== kind) continue;
    values[dof.axis] = pose.q[dof.index]!;
    changed ||= any || pose.q[dof.index] !== skeleton.qRest[dof.index];
  }
  return changed ? values : undefined;
}
