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

/** Radii for picking, in the character's units. */
export interface PickSizes {
  readonly boneRadius: number;
  /** Radius of the spheres at the joints; 0 excludes them. */
  readonly jointRadius: number;
  /** The minimum radius as a fraction of the distance: a constant number of pixels at any depth. */
  readonly tolerance: number;
}

/** The intersection of a ray and a skeleton. */
export interface BoneHit {
  /** The joint that rotates the bone or sphere that was hit. */
  readonly joint: number;
  /** The bone, or null if the joint's sphere was hit. */
  readonly bone: Bone | null;
  /** The point on the ray, in the joint's frame, in model units. */
  readonly point: readonly [number, number, number];
  /** Distance along the ray, in the character's units. */
  readonly distance: number;
}

/**
 * Returns the bone (a capsule) or joint (a sphere) that the ray hits first. A hit within its own
 * radius takes precedence over a hit only within the enlarged minimum radius, so that a slender
 * bone does not catch a ray that is aimed at its neighbor.
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
