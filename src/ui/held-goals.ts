import type { Evaluation } from '../evaluation/evaluation.ts';
import { placeOf } from '../posing/ik/chain-problem.ts';
import type { IkGoal } from '../posing/ik/problem.ts';

/** How much a pin counts against the dragged point. */
const pinWeight = 10;

/** The pins of a character as goals that hold their joints where they are shown now. */
export function heldGoals({ state, characterFromJoint }: Evaluation): IkGoal[] {
  return state.pins
    .filter(({ weight }) => weight > 0)
    .map(({ joint, point, rotation, weight }) => ({
      joint,
      point,
      target: placeOf(characterFromJoint, joint, point),
      ...(rotation ? { rotation } : {}),
      weight: pinWeight * weight,
    }));
}
