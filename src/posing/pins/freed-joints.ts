import { noParent, type Skeleton } from '../../core/skeleton.ts';
import { naturalLength, pathTo } from '../ik/chain.ts';
import type { Pin } from './pin.ts';

/** Joints that may move, and the pins for which they do. */
export interface Freed {
  /** Ascending. */
  readonly joints: readonly number[];
  readonly pins: readonly number[];
}

/**
 * Returns what pins may move, in the order in which it is tried: the limb of each pin, from where the
 * body branches or from another pin; then, for all pins together, all joints from them to the roots,
 * so that pelvis and legs work together. What a limb can hold, nothing else moves for.
 */
export function freedJoints(
  skeleton: Skeleton,
  pins: readonly Pin[],
): {
  readonly limbs: readonly Freed[];
  readonly body: Freed;
} {
  const isRoot = (joint: number): boolean => skeleton.parents[joint] === noParent;
  const held = pins.map(({ joint, rotation }) => ({ joint, isTurned: rotation !== null }));
  const paths = pins.map((pin) => {
    const path = pathTo(skeleton, pin.joint);
    // A joint whose origin alone is held does not move it by turning.
    return pin.rotation || pin.point.some((value) => value !== 0) ? path : path.slice(0, -1);
  });
  const limbs = pins.map(({ joint }, at): Freed => {
    const others = held.filter((each) => each.joint !== joint);
    const first = skeleton.depths[joint]! + 1 - naturalLength(skeleton, joint, others);
    const joints = paths[at]!.slice(first).filter((each) => !isRoot(each));
    return { joints, pins: [at] };
  });
  return { limbs, body: { joints: ascending(paths.flat()), pins: pins.map((_, at) => at) } };
}

function ascending(joints: readonly number[]): number[] {
  return [...new Set(joints)].sort((a, b) => a - b);
}
