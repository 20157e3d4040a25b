import { mat4, vec3 } from 'gl-matrix';
import type { Character } from '../core/character.ts';
import { type Camera, clipFromScene, eyeOf } from './camera.ts';
import type { DisplayTransform } from './display-transform.ts';
import { boneRadius, jointRadius } from './solid-sizes.ts';

/** A half-line of scene space; `direction` is unit. */
export interface Ray {
  readonly origin: vec3;
  readonly direction: vec3;
}

/** What is needed of a posed character to pick its joints. */
export interface PickTarget {
  readonly character: Character;
  readonly display: DisplayTransform;
  /** (jointCount × 16) as posed. */
  readonly worldFromJoint: Float64Array;
}

/** The ray of sight through a point of the picture, x and y from -1 (left, bottom) to 1. */
export function rayThrough(camera: Camera, aspect: number, x: number, y: number): Ray {
  const origin = eyeOf(camera);
  const sceneFromClip = mat4.invert(new Float64Array(16), clipFromScene(camera, aspect));
  if (!sceneFromClip) return { origin, direction: [0, 0, -1] };
  const far = vec3.transformMat4(new Float64Array(3), [x, y, 1], sceneFromClip);
  const direction = vec3.subtract(new Float64Array(3), far, origin);
  return { origin, direction: vec3.normalize(direction, direction) };
}

/**
 * The joint whose sphere, or whose bone (as a capsule: a cylinder with round ends), the ray meets
 * first; null where it meets none.
 *
 * @param tolerance grows the radii by this part of the distance, so that thin and far bones can be hit
 */
export function pickJoint(target: PickTarget, ray: Ray, tolerance: number): number | null {
  const { skeleton, bones } = target.character;
  let nearest = Infinity;
  let picked: number | null = null;
  const offer = (joint: number, from: vec3, to: vec3, radius: number): void => {
    const entry = capsuleEntry(ray, from, to, radius, tolerance);
    if (entry >= nearest) return;
    nearest = entry;
    picked = joint;
  };
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const place = scenePoint(target, joint, [0, 0, 0]);
    offer(joint, place, place, jointRadius);
  }
  for (const { joint, vector } of bones) {
    offer(
      joint,
      scenePoint(target, joint, [0, 0, 0]),
      scenePoint(target, joint, vector),
      boneRadius,
    );
  }
  return picked;
}

function scenePoint(
  { display, worldFromJoint }: PickTarget,
  joint: number,
  point: readonly [number, number, number],
): vec3 {
  const matrix = worldFromJoint.subarray(joint * 16, joint * 16 + 16);
  const posed = vec3.transformMat4(new Float64Array(3), point, matrix);
  return vec3.transformMat4(posed, posed, display.sceneFromCharacter);
}

/**
 * How far along the ray it enters the capsule, or Infinity: from the points of ray and segment that
 * are closest (Ericson 2005, "Real-time collision detection", 5.1.9), back by half the chord there.
 */
function capsuleEntry(
  { origin, direction }: Ray,
  from: vec3,
  to: vec3,
  radius: number,
  tolerance: number,
): number {
  const axis = vec3.subtract(new Float64Array(3), to, from);
  const offset = vec3.subtract(new Float64Array(3), origin, from);
  const [a, b] = [vec3.dot(axis, axis), vec3.dot(axis, direction)];
  const [c, d] = [vec3.dot(axis, offset), vec3.dot(direction, offset)];
  const divisor = a - b * b; // the direction is unit
  const along = divisor > 1e-12 ? clamp01((c - b * d) / divisor) : 0;
  const distance = Math.max(0, along * b - d);
  // The segment's point closest to the ray's, now that the ray is bounded too.
  const part = a > 1e-12 ? clamp01((c + distance * b) / a) : 0;
  const onAxis = vec3.scaleAndAdd(new Float64Array(3), from, axis, part);
  const onRay = vec3.scaleAndAdd(new Float64Array(3), origin, direction, distance);
  const gap = vec3.distance(onAxis, onRay);
  const reach = Math.max(radius, distance * tolerance);
  return gap > reach ? Infinity : distance - Math.sqrt(reach * reach - gap * gap);
}

function clamp01(value: number): number {
  return Math.min(1, Math.max(0, value));
}
