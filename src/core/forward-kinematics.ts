import { mat4, type quat, type vec3 } from 'gl-matrix';
import { MatrixStack } from './matrix-stack.ts';
import { DofKind, type Skeleton } from './skeleton.ts';

/**
 * Writes the matrix from every joint's frame to the character's space, for the values q.
 *
 * `characterFromJoint[j] = characterFromJoint[parent] · T(offset) · R(rest) · D1 · … · Dk` (6.837
 * handout, part 3; the degrees of freedom follow MuJoCo's `qpos`). It visits the depth-first joints
 * once with the matrix stack, in float64, and allocates nothing.
 *
 * @param q (qCount) see `Skeleton.dofQ`
 * @param characterFromJoint (jointCount × 16) column-major, written
 */
export function forwardKinematics(
  skeleton: Skeleton,
  q: Float64Array,
  characterFromJoint: Float64Array,
): void {
  stack.popTo(0);
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    stack.popTo(skeleton.depths[joint]!);
    writeLocalMatrix(skeleton, joint, q, parentFromJoint);
    stack.push(parentFromJoint);
    const top = stack.top;
    for (let i = 0; i < 16; i++) characterFromJoint[joint * 16 + i] = top[i]!;
  }
}

/** Returns the matrices of `forwardKinematics` in a new array. */
export function jointMatrices(skeleton: Skeleton, q: Float64Array): Float64Array {
  const characterFromJoint = new Float64Array(skeleton.jointCount * 16);
  forwardKinematics(skeleton, q, characterFromJoint);
  return characterFromJoint;
}

function writeLocalMatrix(skeleton: Skeleton, joint: number, q: Float64Array, out: mat4): void {
  writeRestMatrix(skeleton, joint, out);
  for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
    applyDof(skeleton, dof, q, out);
  }
}

/** Writes the joint's matrix in its parent's frame before its degrees of freedom are applied. */
export function writeRestMatrix(skeleton: Skeleton, joint: number, out: mat4): void {
  readVector(skeleton.restOffsets, joint * 3, vector);
  readQuaternion(skeleton.restRotations, joint * 4, quaternion);
  mat4.fromRotationTranslation(out, quaternion, vector);
}

/**
 * Multiplies the matrix from the right by the transform of one degree of freedom for the values q.
 */
export function applyDof(skeleton: Skeleton, dof: number, q: Float64Array, out: mat4): void {
  const value = skeleton.dofQ[dof]!;
  switch (skeleton.dofKind[dof] as DofKind) {
    case DofKind.slide:
      readVector(skeleton.dofAxis, dof * 3, vector, q[value]);
      mat4.translate(out, out, vector);
      break;
    case DofKind.hinge:
      readVector(skeleton.dofAxis, dof * 3, vector);
      mat4.rotate(out, out, q[value]!, vector);
      break;
    case DofKind.ball:
      readQuaternion(q, value, quaternion);
      mat4.fromQuat(rotation, quaternion);
      mat4.multiply(out, out, rotation);
      break;
  }
}

function readVector(from: Float64Array, at: number, out: vec3, scale = 1): void {
  for (let i = 0; i < 3; i++) out[i] = from[at + i]! * scale;
}

function readQuaternion(from: Float64Array, at: number, out: quat): void {
  for (let i = 0; i < 4; i++) out[i] = from[at + i]!;
}

const stack = new MatrixStack();
const parentFromJoint: mat4 = new Float64Array(16);
const rotation: mat4 = new Float64Array(16);
const vector: vec3 = new Float64Array(3);
const quaternion: quat = new Float64Array(4);
