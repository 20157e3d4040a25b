import type { DofParts } from '../../core/character-parts.ts';
import { DofKind } from '../../core/skeleton.ts';

export type Triple = readonly [number, number, number];

const axes: readonly Triple[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/**
 * The root can be translated by three slides, in model units, whose values are added to its offset.
 */
export const rootSlides: readonly DofParts[] = axes.map((axis) => ({ kind: DofKind.slide, axis }));

/** A joint that turns as a ball, by a quaternion. */
export const ballDof: DofParts = { kind: DofKind.ball, axis: [0, 0, 0] };

/**
 * The hinges of a ball joint of CSE169: L = T(offset) · Rz · Ry · Rx, with x applied first.
 *
 * @param pose angles about x, y, z, within the limits
 * @param limits of x, y, z, if there are any
 */
export function ballHinges(
  pose: Triple,
  limits: readonly (readonly [number, number] | undefined)[],
): DofParts[] {
  return [2, 1, 0].map((axis) => ({
    kind: DofKind.hinge,
    axis: axes[axis]!,
    rest: [pose[axis]!],
    ...(limits[axis] ? { limits: limits[axis] } : {}),
  }));
}
