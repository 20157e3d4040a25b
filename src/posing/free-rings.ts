import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import { takesAnyTurn, type TurnStart } from './turn-joint.ts';

/**
 * A ring about an axis that is not the joint's own: one of the scene's, or the line of sight.
 * Vectors are in the character's space.
 */
export interface FreeRing {
  /** Which of the scene's axes it is about; null for the line of sight. */
  readonly axis: 0 | 1 | 2 | null;
  readonly center: ReadonlyVec3;
  /** Unit vector along the axis; a positive turn is counterclockwise seen from its tip. */
  readonly normal: ReadonlyVec3;
  /** Unit vector across the axis. */
  readonly mark: ReadonlyVec3;
}

/**
 * Returns a ring about each of some axes at the pivot of a joint that can take any rotation, and
 * none for another joint, which could only come near to what the pointer does.
 */
export function freeRings(
  start: TurnStart,
  axes: readonly Pick<FreeRing, 'axis' | 'normal'>[],
): FreeRing[] {
  if (!takesAnyTurn(start)) return [];
  return axes.map(({ axis, normal }) => {
    const other: ReadonlyVec3 = Math.abs(normal[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0];
    const mark = vec3.cross(new Float64Array(3), normal, other);
    return { axis, normal, center: start.pivot, mark: vec3.normalize(mark, mark) };
  });
}
