import type { mat4 } from 'gl-matrix';
import { vec3 } from 'gl-matrix';
import type { Skeleton } from './skeleton.ts';

/**
 * Computes the corners of all joints' display boxes in a pose, in the character's space.
 *
 * @param characterFromJoint (jointCount × 16)
 * @returns (jointCount × 8 × 3); empty without boxes
 */
export function boxCorners(
  { displayBoxes, jointCount }: Skeleton,
  characterFromJoint: Float64Array,
): Float64Array {
  if (!displayBoxes) return new Float64Array(0);
  const corners = new Float64Array(jointCount * 24);
  for (let joint = 0; joint < jointCount; joint++) {
    const matrix: mat4 = characterFromJoint.subarray(joint * 16, joint * 16 + 16);
    for (let corner = 0; corner < 8; corner++) {
      const at = (joint * 8 + corner) * 3;
      const place = corners.subarray(at, at + 3);
      for (let axis = 0; axis < 3; axis++) {
        place[axis] = displayBoxes[joint * 6 + axis + ((corner >> axis) & 1) * 3]!;
      }
      vec3.transformMat4(place, place, matrix);
    }
  }
  return corners;
}
