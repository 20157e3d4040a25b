import { mat3, quat, vec3 } from 'gl-matrix';
import type { Quaternion, Vector3 } from '../ik/problem.ts';
import type { Pin } from './pin.ts';

/** Where a pin holds its point, in the character's space. */
export interface PinTarget {
  readonly place: Vector3;
  readonly rotation: Quaternion | null;
}

/**
 * Returns where a pin holds its point now: its own place, or that of the joint that it follows.
 *
 * @param followed (pins × 16) see `PoseContext`
 * @param at the pin's index in the list
 */
export function pinTarget(pin: Pin, followed: Float64Array | null, at: number): PinTarget {
  const matrix = followed?.subarray(at * 16, at * 16 + 16);
  if (!pin.follows || !matrix || Number.isNaN(matrix[0])) return pin;
  const { point, rotation } = pin.follows;
  const place = vec3.transformMat4(new Float64Array(3), point, matrix);
  if (!pin.rotation) return { place: vectorOf(place), rotation: null };
  const turned = rotationOf(matrix);
  quat.normalize(turned, quat.multiply(turned, turned, rotation));
  return { place: vectorOf(place), rotation: quaternionOf(turned) };
}

/** The point that a pin holds, where it is in a pose. */
export function pinnedPoint(
  { joint, point }: Pick<Pin, 'joint' | 'point'>,
  characterFromJoint: Float64Array,
): Vector3 {
  const matrix = characterFromJoint.subarray(joint * 16, joint * 16 + 16);
  return vectorOf(vec3.transformMat4(new Float64Array(3), point, matrix));
}

/** The rotation of a joint in a pose, in the character's space. */
export function jointRotation(joint: number, characterFromJoint: Float64Array): Quaternion {
  return quaternionOf(rotationOf(characterFromJoint.subarray(joint * 16, joint * 16 + 16)));
}

/** The rotation of a matrix whose columns are orthogonal and of equal length. */
function rotationOf(matrix: Float64Array): quat {
  const unit = mat3.fromMat4(new Float64Array(9), matrix);
  const scale = 1 / Math.hypot(matrix[0]!, matrix[1]!, matrix[2]!);
  mat3.multiplyScalar(unit, unit, scale);
  const rotation = quat.fromMat3(new Float64Array(4), unit);
  return quat.normalize(rotation, rotation);
}

function vectorOf(vector: vec3): Vector3 {
  return [vector[0], vector[1], vector[2]];
}

function quaternionOf(rotation: quat): Quaternion {
  return [rotation[0], rotation[1], rotation[2], rotation[3]];
}
