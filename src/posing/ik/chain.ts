import { noParent, type Skeleton } from '../../core/skeleton.ts';
import { subtreeEnd } from '../../core/subtree.ts';

/** A joint that is held in its place, where a chain may begin. */
export interface HeldJoint {
  readonly joint: number;
  /** Whether it is also held in its orientation, so that a chain can begin only below it. */
  readonly isTurned: boolean;
}

/** The user's choice of how many joints a chain that ends at a joint has. */
export interface ChainLength {
  readonly joint: number;
  readonly count: number;
}

/** The joints from a root to a joint, which is the last one. */
export function pathTo({ parents }: Skeleton, joint: number): number[] {
  const path: number[] = [];
  for (let each = joint; each !== noParent; each = parents[each]!) path.unshift(each);
  return path;
}

/** How many joints the chain to a joint has: by the user's choice for that joint, or by nature. */
export function chainLength(
  skeleton: Skeleton,
  joint: number,
  chosen: ChainLength | null,
  pins: readonly { readonly joint: number; readonly rotation: unknown }[],
): number {
  if (chosen?.joint !== joint) {
    const held = pins.map((pin) => ({ joint: pin.joint, isTurned: pin.rotation !== null }));
    return naturalLength(skeleton, joint, held);
  }
  return Math.max(1, Math.min(chosen.count, pathTo(skeleton, joint).length));
}

/**
 * Returns how many joints a chain that ends at a joint has by nature: those below the nearest
 * ancestor at which the body branches, or from the nearest one that is held.
 */
export function naturalLength(
  skeleton: Skeleton,
  joint: number,
  held: readonly HeldJoint[] = [],
): number {
  const { parents } = skeleton;
  let count = 1;
  for (let each = joint; parents[each] !== noParent; each = parents[each]!) {
    const parent = parents[each]!;
    const holder = held.find((one) => one.joint === parent);
    if (holder) return holder.isTurned ? count : count + 1;
    if (branchesAbove(skeleton, each)) return count;
    count++;
  }
  return count;
}

/**
 * Whether the parent of a joint has another child whose branch is worth one. Beside a branch of
 * several joints a single joint is not: many files have helpers and ends of bones.
 */
function branchesAbove(skeleton: Skeleton, joint: number): boolean {
  const { parents, jointCount } = skeleton;
  const parent = parents[joint]!;
  const worth = Math.min(2, heightOf(skeleton, joint));
  for (let other = parent + 1; other < jointCount; other++) {
    if (parents[other] !== parent || other === joint) continue;
    if (heightOf(skeleton, other) >= worth) return true;
  }
  return false;
}

/** How many joints the longest path from a joint downward has, with the joint itself. */
function heightOf(skeleton: Skeleton, joint: number): number {
  const { depths } = skeleton;
  const deepest = depths.subarray(joint, subtreeEnd(skeleton, joint));
  return 1 + Math.max(...deepest) - depths[joint]!;
}
