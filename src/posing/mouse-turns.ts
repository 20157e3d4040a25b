import { type ReadonlyVec3, vec3 } from 'gl-matrix';

/**
 * The axes of the view, as unit vectors in the character's space; `look` points into the picture.
 */
export interface ViewAxes {
  readonly right: ReadonlyVec3;
  readonly up: ReadonlyVec3;
  readonly look: ReadonlyVec3;
}

/**
 * Radians per pixel. CS354's program rotates by 0.02 per mouse event, whatever its distance. An
 * event is about four pixels, and pixels do not depend on the machine.
 */
export const coursePixelRate = 0.02 / 4;
/** Radians per pixel for rolling: half a degree. */
export const knobPixelRate = Math.PI / 360;

/**
 * If an axis points toward the viewer more than this (a sine), motion to the right rotates about
 * it.
 */
const towardEye = 0.1;

/**
 * Returns the rotation about a unit axis when the pointer strokes a knob: the near side of the knob
 * moves with the pointer, and motion along the axis has no effect.
 *
 * @param motion pixels, right and up
 */
export function knobAngle(
  axis: ReadonlyVec3,
  { right, up, look }: ViewAxes,
  motion: readonly [number, number],
  rate: number,
): number {
  const nearSide = vec3.cross(new Float64Array(3), look, axis); // axis × (toward the viewer)
  const length = vec3.length(nearSide);
  if (length < towardEye) return rate * motion[0];
  const along = vec3.dot(nearSide, right) * motion[0] + vec3.dot(nearSide, up) * motion[1];
  return (rate * along) / length;
}
