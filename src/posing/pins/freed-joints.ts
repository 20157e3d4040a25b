import { noParent, type Skeleton } from '../../core/skeleton.ts';
import { naturalLength, pathTo } from '../ik/chain.ts';
import type { Pin } from './pin.ts';

/**
 * Returns the sets of joints that pins may move, each with the one before: the limbs alone, from
 * each pin to where the body branches or to another pin; then all joints on the way to the root;
 * then the roots too, so that pelvis and legs work together. What a small set can hold, no larger
 * one touches. All are ascending.
 */
export function freedJoints(skeleton: Skeleton, pins: readonly Pin[]): readonly number[][] {
  const limbs = new Set<number>();
  const paths = new Set<number>();
  const held = pins.map(({ joint, rotation }) => ({ joint, isTurned: rotation !== null }));
  for (const pin of pins) {
    const path = pathTo(skeleton, pin.joint);
    const others = held.filter(({ joint }) => joint !== pin.joint);
    const limb = path.slice(-naturalLength(skeleton, pin.joint, others));
    // A joint whose origin alone is held does not move it by turning.
    if (!pin.rotation && pin.point.every((value) => value === 0)) {
      path.pop();
      limb.pop();
    }
    for (const joint of limb) limbs.add(joint);
    for (const joint of path) paths.add(joint);
  }
  const isRoot = (joint: number): boolean => skeleton.parents[joint] === noParent;
  const sets = [
    [...limbs].filter((joint) => !isRoot(joint)),
    [...limbs, ...paths].filter((joint) => !isRoot(joint)),
    [...limbs, ...paths],
  ];
  return sets
    .map((joints) => [...new Set(joints)].sort((a, b) => a - b))
    .filter((joints, at, all) => joints.length > (all[at - 1]?.length ?? 0));
}
