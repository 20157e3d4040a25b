import type { DiagnosticLog } from './diagnostics.ts';
import { worldMatrices } from './forward-kinematics.ts';
import type { Skeleton } from './skeleton.ts';

/** Says so where all joints stand on one point at the file's pose: they are no figure to turn. */
export function reportCoincidentJoints(skeleton: Skeleton, log: DiagnosticLog): void {
  if (skeleton.jointCount < 2) return;
  const worldFromJoint = worldMatrices(skeleton, skeleton.qRest);
  const first = worldFromJoint.subarray(12, 15);
  for (let at = 12; at < worldFromJoint.length; at += 16) {
    if (first.some((value, axis) => worldFromJoint[at + axis] !== value)) return;
  }
  log.warn({
    code: 'character/coincident',
    expected: 'joints apart from each other',
    found: `all ${skeleton.jointCount} on one point`,
    effect: 'they are drawn without bones between them',
  });
}
