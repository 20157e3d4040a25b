import type { ClipParts } from '../../core/motion/clip-parts.ts';
import type { Actor } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Editor } from '../editor.ts';

/** The clip that the timeline shows. */
export interface ChosenClip {
  readonly actor: Actor;
  readonly clip: ClipParts;
  readonly index: number;
}

/** Returns the clip that the timeline shows, if the selected character has one. */
export function chosenClip({ store, session, transport }: Editor): ChosenClip | null {
  const actor = selectedActor(store, session);
  const index = transport.clipIndex;
  const clip = actor?.clips[index];
  return actor && clip ? { actor, clip, index } : null;
}
