import type { HoveredLimb, Session } from '../document/session.ts';
import { canTurn } from '../posing/joint-frames.ts';
import type { Looking } from './editor.ts';

/** Whether a left drag on some limb poses it; if not, no limb needs to be looked for. */
export function anyIsLive({ posesBy, playing, boneMode, selectedJoint }: Session): boolean {
  if (boneMode.value) return true;
  return posesBy.value === 'selection' && !playing.value && selectedJoint.value !== null;
}

/**
 * Whether a left drag on a limb poses it: in bone mode every limb of the selected character,
 * otherwise the limb that was selected before, unless the workspace poses in bone mode alone. All
 * other drags are the camera's, so that the first one never bends a character.
 */
export function isLive({ evaluations, session }: Looking, limb: HoveredLimb): boolean {
  const { selectedActorId, selectedJoint, boneMode } = session;
  const shown = evaluations.selected();
  if (!anyIsLive(session) || !shown || limb.actorId !== selectedActorId.value) return false;
  if (!canTurn(shown.state.character.skeleton, limb.joint)) return false;
  return boneMode.value || limb.joint === selectedJoint.value;
}
