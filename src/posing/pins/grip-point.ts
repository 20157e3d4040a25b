import { mat4, vec3 } from 'gl-matrix';
import { bonesOf } from '../../core/bones.ts';
import type { Character } from '../../core/character.ts';
import { jointMatrices } from '../../core/forward-kinematics.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import { subtreeEnd } from '../../core/subtree.ts';
import type { Vector3 } from '../ik/problem.ts';

/** The most joints in a row from a hand or foot to its end, with and without several fingers. */
const [longestEnd, longestFinger] = [3, 5];
const leastFingers = 3;

/**
 * Returns the point by which another character takes hold of a joint, in its frame: the middle of
 * all bones of a hand, a foot or a head, and the origin of a joint within a limb.
 */
export function gripPoint(character: Character, joint: number): Vector3 {
  const { skeleton } = character;
  if (!isEnd(skeleton, joint)) return [0, 0, 0];
  const end = subtreeEnd(skeleton, joint);
  const bones = bonesOf(character).filter((bone) => bone.joint >= joint && bone.joint < end);
  if (bones.length === 0) return [0, 0, 0];
  const matrices = jointMatrices(skeleton, skeleton.qRest);
  const matrixOf = (each: number): Float64Array => matrices.subarray(each * 16, each * 16 + 16);
  const jointFromCharacter = mat4.invert(new Float64Array(16), matrixOf(joint))!;
  const sum: vec3 = [0, 0, 0];
  for (const bone of bones) {
    const middle = vec3.scale(new Float64Array(3), [...bone.vector], 0.5);
    vec3.transformMat4(middle, middle, matrixOf(bone.joint));
    vec3.add(sum, sum, vec3.transformMat4(middle, middle, jointFromCharacter));
  }
  vec3.scale(sum, sum, 1 / bones.length);
  return [sum[0], sum[1], sum[2]];
}

/** Whether only an end of the body is below a joint: few joints in a row, or fingers. */
function isEnd(skeleton: Skeleton, joint: number): boolean {
  const { parents, depths } = skeleton;
  const end = subtreeEnd(skeleton, joint);
  const height = 1 + Math.max(...depths.subarray(joint, end)) - depths[joint]!;
  const children = parents.subarray(joint + 1, end).filter((parent) => parent === joint).length;
  return height <= longestEnd || (children >= leastFingers && height <= longestFinger);
}
