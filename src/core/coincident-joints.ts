import type { DiagnosticLog } from './diagnostics.ts';
import { jointMatrices } from './forward-kinematics.ts';
import type { Skeleton } from './skeleton.ts';

/** Says so where all joints stand on one point at the file's pose: they are no figure to turn. */
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
