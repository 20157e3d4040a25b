import type { Skin } from '../../core/skin.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import { subtreeEnd } from '../../core/subtree.ts';

/**
 * Returns the joints whose turning deforms a skin, ascending: they move a part of what follows the
 * skeleton. One that moves nothing, or all of it as a whole, deforms nothing.
 */
export function deformingJoints(
  skeleton: Skeleton,
  { paletteJoint, entries, weights }: Skin,
): number[] {
  const { jointCount } = skeleton;
  // What follows no joint stays; it counts behind the last joint.
  const used = new Uint8Array(jointCount + 1);
  entries.forEach((entry, i) => {
    if (weights[i] !== 0) used[Math.min(paletteJoint[entry]!, jointCount)] = 1;
  });
  const isUsed = (from: number, to: number): boolean => used.subarray(from, to).includes(1);
  return Array.from({ length: jointCount }, (_, joint) => joint).filter((joint) => {
    const end = subtreeEnd(skeleton, joint);
    return isUsed(joint, end) && (isUsed(0, joint) || isUsed(end, jointCount + 1));
  });
}
