import type { HoveredLimb, Session } from '../document/session.ts';

/** Returns the limb under the pointer if it is one of the selected actor. */
export function hoveredOf({ hoveredLimb, selectedActorId }: Session): HoveredLimb | null {
  const limb = hoveredLimb.value;
  return limb?.actorId === selectedActorId.value ? limb : null;
}
