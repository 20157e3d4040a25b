import { jointRotation } from './joint-rotation.ts';
import { jointValue } from './joint-value.ts';
import { morphWeight } from './morph-weight.ts';
import type { TargetKind } from './motion.ts';
import { pinValue } from './pin-value.ts';

/** Every kind of target that a motion can have. A target of another kind is kept for saving. */
export const targetKinds: readonly TargetKind[] = [
  jointValue,
  jointRotation,
  morphWeight,
  pinValue,
];
