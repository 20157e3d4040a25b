import { mat4, vec3 } from 'gl-matrix';
import type { Bone } from '../core/bones.ts';
import { distanceOfClosest, pointOnRay, type Ray, rayCapsule } from '../core/ray.ts';
import type { Skeleton } from '../core/skeleton.ts';

/** A posed skeleton, in the character's space. */
export interface PosedBones {
  readonly skeleton: Skeleton;
  readonly bones: readonly Bone[];
  /** (jointCount × 16) column-major. */
  readonly characterFromJoint: Float64Array;
}

/** How thick things are for picking, in the character's units. */
export interface PickSizes {
  readonly boneRadius: number;
  /** Of the spheres at the joints; 0 leaves them out. */
  readonly jointRadius: number;
  /** Radii are at least this part of the distance: a number of pixels at any depth. */
  readonly tolerance: number;
}

/** Where a ray meets a skeleton. */
export interface BoneHit {
  /** The joint that turns what was hit. */
  readonly joint: number;
  /** The bone, or null where the joint's sphere was hit. */
  readonly bone: Bone | null;
  /** On the ray, in the joint's frame, model units. */
  readonly point: readonly [number, number, number];
  /** Along the ray, in the character's units. */
  readonly distance: number;
}

/**
 * The bone, as a capsule, or joint, as a sphere, that the ray meets first. What it meets at its own
 * thickness comes before what is only near enough, so that a slender bone does not take what is
 * pointed at beside it.
 */
export function pickBone(posed: PosedBones, ray: Ray, sizes: PickSizes): BoneHit | null {
  const { skeleton, bones } = posed;
  const candidates: Candidate[] = [];
  if (sizes.jointRadius > 0) {
    for (let joint = 0; joint < skeleton.jointCount; joint++) {
      const place = placeOf(posed, joint, [0, 0, 0]);
      offer(joint, null, place, place, sizes.jointRadius);
    }
  }
  for (const bone of bones) {
    const from = placeOf(posed, bone.joint, [0, 0, 0]);
    offer(bone.joint, bone, from, placeOf(posed, bone.joint, bone.vector), sizes.boneRadius);
  }
  if (candidates.length === 0) return null;
  return hitOf(
    posed,
    ray,
    candidates.reduce((best, each) => (isBefore(each, best) ? each : best)),
  );

  function offer(joint: number, bone: Bone | null, from: vec3, to: vec3, radius: number): void {
    const direct = rayCapsule(ray, from, to, radius);
    if (direct < Infinity) {
      candidates.push({ joint, bone, distance: direct, isDirect: true });
      return;
    }
    const near = sizes.tolerance * distanceOfClosest(ray, from, to);
    if (near <= radius) return;
    const distance = rayCapsule(ray, from, to, near);
    if (distance < Infinity) candidates.push({ joint, bone, distance, isDirect: false });
  }
}

interface Candidate {
  readonly joint: number;
  readonly bone: Bone | null;
  readonly distance: number;
  readonly isDirect: boolean;
}

function isBefore(a: Candidate, b: Candidate): boolean {
  return a.isDirect === b.isDirect ? a.distance < b.distance : a.isDirect;
}

function hitOf(posed: PosedBones, ray: Ray, { joint, bone, distance }: Candidate): BoneHit {
  const jointFromWorld: mat4 = new Float64Array(16);
  mat4.invert(jointFromWorld, matrixOf(posed, joint));
  const place = pointOnRay(ray, distance);
  vec3.transformMat4(place, place, jointFromWorld);
  return { joint, bone, point: [place[0], place[1], place[2]], distance };
}

function placeOf(posed: PosedBones, joint: number, point: readonly [number, number, number]): vec3 {
  return vec3.transformMat4(new Float64Array(3), point, matrixOf(posed, joint));
}

function matrixOf({ characterFromJoint }: PosedBones, joint: number): Float64Array {
  return characterFromJoint.subarray(joint * 16, joint * 16 + 16);
}
