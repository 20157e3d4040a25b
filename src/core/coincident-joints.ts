import type { DiagnosticLog } from './diagnostics.ts';
import { jointMatrices } from './forward-kinematics.ts';
import type { Skeleton } from './skeleton.ts';

/**
 * Reports if all joints are at one point in the file's pose, because such a skeleton can't be posed
 * sensibly.
 */
export function reportCoincidentJoints(skeleton: Skeleton, log: DiagnosticLog): void {
  if (skeleton.jointCount < 2) return;
  const characterFromJoint = jointMatrices(skeleton, skeleton.qRest);
  const first = characterFromJoint.subarray(12, 15);
  for (let at = 12; at < characterFromJoint.length; at += 16) {
    if (first.some((value, axis) => characterFromJoint[at + axis] !== value)) return;
  }
  log.warn({
    code: 'character/coincident',
    expected: 'joints apart from each other',
    found: `all ${skeleton.jointCount} on one point`,
    effect: 'they are drawn without bones between them',
  });
}
