import type { Skeleton } from '../../core/skeleton.ts';
import type { Pin } from './pin.ts';
import { pinnedPoint, pinTarget } from './pin-target.ts';

/** A character whose pins are shown; an evaluation is one. */
export interface ShownPins {
  readonly state: {
    readonly pins: readonly Pin[];
    readonly character: { readonly skeleton: Skeleton };
  };
  readonly characterFromJoint: Float64Array;
  readonly followed: Float64Array | null;
}

/** A smaller distance, as a part of the way from the root to the joint, is what solving leaves. */
const leastMiss = 1e-3;

/**
 * Returns how far a pinned joint is from its place because it can't reach it, in model units, or 0
 * if it is there.
 */
export function pinMiss({ state, characterFromJoint, followed }: ShownPins, joint: number): number {
  const at = state.pins.findIndex((pin) => pin.joint === joint);
  const pin = state.pins[at];
  if (!pin || pin.weight === 0) return 0;
  const [x, y, z] = pinnedPoint(pin, characterFromJoint);
  const { place } = pinTarget(pin, followed, at);
  const miss = Math.hypot(x - place[0], y - place[1], z - place[2]);
  return miss > leastMiss * pathLength(state.character.skeleton, joint) ? miss : 0;
}

/** The length of the links from the root to a joint, without that to the root; 1 if it is zero. */
export function pathLength({ parents, restOffsets }: Skeleton, joint: number): number {
  let length = 0;
  for (let each = joint; parents[each]! >= 0; each = parents[each]!) {
    length += Math.hypot(...restOffsets.subarray(each * 3, each * 3 + 3));
  }
  return length || 1;
}
