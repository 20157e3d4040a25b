import { selectedActor } from '../document/selected-actor.ts';
import { holdsPosesOf, type PoseFormat, poseFormats } from '../formats/pose-formats.ts';
import type { Looking } from './editor.ts';

/** The formats beside POSE.json that can hold the pose of the selected character. */
export function otherPoseFormats({
  store,
  session,
}: Pick<Looking, 'store' | 'session'>): readonly PoseFormat[] {
  const actor = selectedActor(store, session);
  if (!actor) return [];
  return poseFormats.slice(1).filter((format) => holdsPosesOf(format, actor.character));
}
