import { jointMatrices } from '../core/forward-kinematics.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { noJoint, type Skin } from '../core/skin.ts';

/**
 * The check that the 6.837 handout describes (4.4.1): with untouched sliders, T and B⁻¹ of every
 * joint are each other's inverse. Returns the largest |T · B⁻¹ − I| over all joints and elements,
 * in float64.
 */
export function largestBindError(skeleton: Skeleton, skin: Skin): number {
  const characterFromJoint = jointMatrices(skeleton, skeleton.qRest);
  let largest = 0;
  skin.paletteJoint.forEach((joint, entry) => {
    if (joint === noJoint) return;
    for (let row = 0; row < 4; row++) {
      for (let column = 0; column < 4; column++) {
        let sum = row === column ? -1 : 0;
        for (let k = 0; k < 4; k++) {
          const t = characterFromJoint[joint * 16 + k * 4 + row]!;
          sum += t * skin.jointFromBind[entry * 16 + column * 4 + k]!;
        }
        largest = Math.max(largest, Math.abs(sum));
      }
    }
  });
  return largest;
}
