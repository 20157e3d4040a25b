import { type ReadonlyVec3, vec3 } from 'gl-matrix';

/** How the view stands, unit vectors of the character's space; `look` goes into the picture. */
export interface ViewAxes {
  readonly right: ReadonlyVec3;
  readonly up: ReadonlyVec3;
  readonly look: ReadonlyVec3;
}

/**
 * Radians a pixel. CS354's program turns by 0.02 at each event of the mouse, however far it went;
 * an event is about four pixels, and pixels don't depend on the machine.
 */
export const coursePixelRate = 0.02 / 4;
/** Radians a pixel for what is rolled like a knob: half a degree. */
export const knobPixelRate = Math.PI / 360;

/** An axis that points at the eye more than this (a sine) is turned by motion to the right. */
const towardEye = 0.1;

/**
 * The angle about a unit axis by which a knob turns when a pointer strokes it: its near side goes
 * with the motion, and motion along the axis does nothing.
 *
 * @param motion pixels, right and up
 */
export function knobAngle(
  axis: ReadonlyVec3,
  { right, up, look }: ViewAxes,
  motion: readonly [number, number],
  rate: number,
): number {
  const nearSide = vec3.cross(new Float64Array(3), look, axis); // axis × (toward the eye)
  const length = vec3.length(nearSide);
  if (length < towardEye) return rate * motion[0];
  const along = vec3.dot(nearSide, right) * motion[0] + vec3.dot(nearSide, up) * motion[1];
  return (rate * along) / length;
}
