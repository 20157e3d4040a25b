import { gimbalLock, isLockedAt } from '../posing/gimbal-lock.ts';
import type { Looking, Posing } from './editor.ts';
import { axisNames, jointValues } from './joint-values.ts';

/**
 * What is to be known where two of the selected joint's angles turn about one axis, with the way out;
 * empty elsewhere.
 */
export function gimbalText({ evaluations, session, ballAngles }: Looking & Posing): string {
  const shown = evaluations.selected();
  const joint = session.selectedJoint.value;
  if (!shown || joint === null || session.playing.value) return '';
  const { skeleton } = shown.state.character;
  const { q } = shown.pose;
  const values = jointValues(skeleton, joint);
  // The rings of a ball are about its own axes; only its three angles coincide, R = Rx · Ry · Rz.
  const ball = values.find(({ ofBall }) => ofBall);
  if (ball && isLockedAt(ballAngles.of(skeleton, q, ball.index)[1])) {
    return 'X and Z turn about one axis here; use the rings';
  }
  const lock = gimbalLock(skeleton, joint, q);
  if (!lock) return '';
  const names = values
    .filter(({ isAngle, index }) => isAngle && lock.includes(index))
    .map(({ axis }) => axisNames[axis]);
  return `${names.join(' and ')} turn about one axis here; use a ring of the scene’s axes or the outer one`;
}
