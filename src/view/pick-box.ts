import { mat4, vec3 } from 'gl-matrix';
import type { Ray } from '../core/ray.ts';
import type { PickTarget } from './picking.ts';

/** A joint whose box the ray hits, and the distance along the ray. */
export interface BoxHit {
  readonly joint: number;
  /** The distance in the character's units. */
  readonly distance: number;
}

/**
 * Returns the joint whose box the ray enters first, or null if it hits none.
 *
 * @param ray in the character's space
 */
export function pickBox(
  { character: { skeleton }, characterFromJoint }: PickTarget,
  { origin, direction }: Ray,
): BoxHit | null {
  const { displayBoxes, jointCount } = skeleton;
  if (!displayBoxes) return null;
  let nearest: BoxHit | null = null;
  for (let joint = 0; joint < jointCount; joint++) {
    const posed = characterFromJoint.subarray(joint * 16, joint * 16 + 16);
    const jointFromWorld = mat4.invert(new Float64Array(16), posed);
    if (!jointFromWorld) continue;
    // The direction is not normalized again, so that distances stay in the character's units.
    const from = vec3.transformMat4(new Float64Array(3), origin, jointFromWorld);
    const tip = vec3.add(new Float64Array(3), origin, direction);
    const along = vec3.subtract(tip, vec3.transformMat4(tip, tip, jointFromWorld), from);
    const distance = boxEntry(from, along, displayBoxes.subarray(joint * 6, joint * 6 + 6));
    if (distance < (nearest?.distance ?? Infinity)) nearest = { joint, distance };
  }
  return nearest;
}

/**
 * Returns the distance along the ray at which it enters the box, or Infinity (Kay and Kajiya 1986,
 * slabs).
 */
function boxEntry(origin: vec3, direction: vec3, box: Float32Array): number {
  let [enter, leave] = [0, Infinity];
  for (let axis = 0; axis < 3; axis++) {
    const [low, high] = [box[axis]! - origin[axis]!, box[axis + 3]! - origin[axis]!];
    const speed = direction[axis]!;
    if (Math.abs(speed) < 1e-15) {
      if (low > 0 || high < 0) return Infinity;
      continue;
    }
    enter = Math.max(enter, Math.min(low / speed, high / speed));
    leave = Math.min(leave, Math.max(low / speed, high / speed));
  }
  return enter <= leave ? enter : Infinity;
}
