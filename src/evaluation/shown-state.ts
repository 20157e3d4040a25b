import type { ShownState } from '../document/keying-targets.ts';
import type { ShownJoints } from '../document/pin-edits.ts';
import type { Evaluation } from './evaluation.ts';

/** What a character shows and edits start from, as a copy. */
export function shownState(evaluation: Evaluation): ShownState {
  return { ...evaluation.snapshot(), pins: evaluation.pins };
}

/** A character with its pins where a clip has moved them, from which edits of pins start. */
export function shownPins({ state, pins, characterFromJoint }: Evaluation): ShownJoints {
  return { state: pins === state.pins ? state : { ...state, pins }, characterFromJoint };
}
