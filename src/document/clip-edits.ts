import { assert } from '../core/assert.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import { type Edit, editActor } from './edit.ts';
import type { ActorId } from './scene.ts';

/** Changes one of an actor's clips. */
export function editClip(
  id: ActorId,
  index: number,
  label: string,
  edit: (clip: ClipParts) => ClipParts,
): Edit {
  return editActor(id, label, (actor) => {
    const clip = actor.clips[index];
    assert(clip !== undefined, 'a clip of the character');
    const edited = edit(clip);
    return edited === clip ? actor : { ...actor, clips: actor.clips.with(index, edited) };
  });
}
