import { writeRotationQuaternion } from '../core/rotation-quaternion.ts';
import { noJoint, type Skin } from '../core/skin.ts';
import { bindFactors } from './stretch.ts';

/**
 * Writes the rigid motion of a palette entry: `characterFromJoint · jointFromBind` without the
 * stretch that the inverse bind matrix may have.
 *
 * @param motion (16) column-major, written
 */
export function writeRigidMotion(
  skin: Skin,
  characterFromJoint: Float64Array,
  entry: number,
  motion: Float64Array,
): void {
  const { rigidFromBind } = bindFactors(skin);
  const joint = skin.paletteJoint[entry]!;
  const bind = entry * 16;
  if (joint === noJoint) {
    for (let i = 0; i < 16; i++) motion[i] = rigidFromBind[bind + i]!;
    return;
  }
  for (let column = 0; column < 16; column += 4) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) {
        sum += characterFromJoint[joint * 16 + k * 4 + row]! * rigidFromBind[bind + column + k]!;
      }
      motion[column + row] = sum;
    }
  }
}

/**
 * Writes the unit quaternion xyzw by which a palette entry turns, `characterFromJoint ·
 * jointFromBind` without stretch.
 *
 * @param out written from `at` on
 */
export function writeEntryRotation(
  skin: Skin,
  characterFromJoint: Float64Array,
  entry: number,
  out: Float64Array,
  at: number,
): void {
  writeRigidMotion(skin, characterFromJoint, entry, motion);
  writeRotationQuaternion(motion, 0, out, at);
}

const motion = new Float64Array(16);
