import { noParent, type Skeleton } from './skeleton.ts';

/** The last joint of j's subtree plus one: joints j … end - 1 are j and all its descendants. */
export function subtreeEnd(skeleton: Skeleton, joint: number): number {
  const { depths, jointCount } = skeleton;
  let end = joint + 1;
  while (end < jointCount && depths[end]! > depths[joint]!) end++;
  return end;
}

/**
 * The root that POSE.json's `root` moves: the one with the lowest index in the file, or -1 without
 * joints.
 */
export function firstRoot(skeleton: Skeleton): number {
  for (const joint of skeleton.jointOfSource)
    if (skeleton.parents[joint] === noParent) return joint;
  return -1;
}
