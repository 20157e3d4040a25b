import type { CharacterImage } from '../core/character.ts';
import type { NormalsId } from '../core/skin.ts';
import type { ActorLook } from './actor-look.ts';
import { type Edit, editActor } from './edit.ts';
import type { ActorId } from './scene.ts';

/** Changes some of how an actor is drawn and handled. */
export function setLook(id: ActorId, change: Partial<ActorLook>, label: string): Edit {
  return editActor(id, label, (actor) => ({ ...actor, look: { ...actor.look, ...change } }));
}

/** Makes an actor look, and its normals follow, as a course has it. */
export function dress(
  id: ActorId,
  change: Partial<ActorLook>,
  normals: NormalsId | undefined,
  label: string,
): Edit {
  return editActor(id, label, (actor) => ({
    ...actor,
    look: { ...actor.look, ...change },
    normals: normals ?? actor.normals,
  }));
}

/** Covers an actor with an image. */
export function setImage(id: ActorId, image: CharacterImage): Edit {
  return setLook(id, { surface: 'image', image }, `Texture ${image.name}`);
}
