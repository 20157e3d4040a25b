import { vec3 } from 'gl-matrix';
import { bonesOf } from '../core/bones.ts';
import type { Character } from '../core/character.ts';
import { type Ray, rayInFrame } from '../core/ray.ts';
import { type BoneHit, pickBone as pickPosedBone } from '../posing/pick-bone.ts';
import type { Camera } from '../document/camera.ts';
import { axesOf, eyeOf, halfHeightOf, reachOf } from './camera.ts';
import type { DisplayTransform } from '../evaluation/display-transform.ts';
import { boneReach, jointRadius } from './solid-sizes.ts';

/** The parts of a posed character that are needed to pick its joints. */
export interface PickTarget {
  readonly character: Character;
  readonly display: DisplayTransform;
  /** (jointCount × 16) in the current pose. */
  readonly characterFromJoint: Float64Array;
}

/**
 * Returns the view ray through a point of the picture, with x and y from -1 (left, bottom) to 1.
 */
export function rayThrough(camera: Camera, aspect: number, x: number, y: number): Ray {
  const { right, up, look } = axesOf(camera);
  const height = halfHeightOf(camera);
  const across = vec3.scale(new Float64Array(3), right, x * height * aspect);
  vec3.scaleAndAdd(across, across, up, y * height);
  const origin = eyeOf(camera);
  if (camera.projection === 'orthographic') {
    return { origin: vec3.add(origin, origin, across), direction: look };
  }
  const direction = vec3.scaleAndAdd(across, across, look, camera.distance);
  return { origin, direction: vec3.normalize(direction, direction) };
}

/**
 * Transforms a ray of the scene to the character's space, which its joints, vertices and pose use.
 */
export function characterRay({ sceneFromCharacter }: DisplayTransform, ray: Ray): Ray {
  return rayInFrame(ray, sceneFromCharacter);
}

/**
 * Returns the size that a pixel of a view `viewHeight` tall covers, as a fraction of its distance.
 */
export function sizeOfPixel(camera: Camera, viewHeight: number): number {
  return (2 * halfHeightOf(camera)) / reachOf(camera) / viewHeight;
}

/**
 * Returns the joint whose sphere or bone the ray of the scene hits first, or null if it hits none.
 *
 * @param tolerance the smallest radius as a fraction of the distance, so that thin and far bones
 *   can be hit
 */
export function pickJoint(target: PickTarget, ray: Ray, tolerance: number): BoneHit | null {
  return pick(target, ray, tolerance, jointRadius);
}

/** Works like `pickJoint`, but only for bones, which can be turned by their far ends. */
export function pickBone(target: PickTarget, ray: Ray, tolerance: number): BoneHit | null {
  return pick(target, ray, tolerance, 0);
}

function pick(target: PickTarget, ray: Ray, tolerance: number, sphere: number): BoneHit | null {
  const { character, display, characterFromJoint } = target;
  const { skeleton } = character;
  const bones = bonesOf(character);
  return pickPosedBone({ skeleton, bones, characterFromJoint }, characterRay(display, ray), {
    boneRadius: boneReach / display.scale,
    jointRadius: sphere / display.scale,
    tolerance,
  });
}
