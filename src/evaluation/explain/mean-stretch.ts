import type { Skin } from '../../core/skin.ts';
import type { Vector3 } from '../../posing/ik/problem.ts';
import { bindFactors } from '../../skinning/stretch.ts';
import type { SignedInfluence } from './quaternions.ts';

/** A vector by the mean stretch of influences, or null if the skin stretches nothing. */
export function stretchedPlace(
  skin: Skin,
  signed: readonly SignedInfluence[],
  [x, y, z]: Vector3,
): Vector3 | null {
  const { stretch } = bindFactors(skin);
  if (!stretch) return null;
  const total = signed.reduce((sum, { weight }) => sum + Math.abs(weight), 0);
  const row = (at: number): number =>
    signed.reduce((sum, { entry, weight }) => {
      const from = entry * 9 + at;
      const own = stretch[from]! * x + stretch[from + 1]! * y + stretch[from + 2]! * z;
      return sum + (Math.abs(weight) / total) * own;
    }, 0);
  return [row(0), row(3), row(6)];
}
