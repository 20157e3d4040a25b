import type { HoveredLimb } from '../document/session.ts';
import { canTurn } from '../posing/joint-frames.ts';
import type { Looking } from './editor.ts';

/**
 * Whether a left drag on a limb poses it: in bone mode every limb of the selected character,
 * otherwise the limb that was selected before, unless the workspace poses in bone mode alone. All
 * other drags are the camera's, so that the first one never bends a character.
 */
export function isLive({ evaluations, session }: Looking, limb: HoveredLimb): boolean {
  const { selectedActorId, selectedJoint, boneMode, posesBy, playing } = session;
  const shown = evaluations.selected();
  if (!shown || limb.actorId !== selectedActorId.value) return false;
  if (!canTurn(shown.state.character.skeleton, limb.joint)) return false;
  if (boneMode.value) return true;
  return posesBy.value === 'selection' && !playing.value && limb.joint === selectedJoint.value;
}
