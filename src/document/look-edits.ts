import type { ActorLook } from './actor-look.ts';
import { type Edit, editActor } from './edit.ts';
import type { ActorId } from './scene.ts';

/** Changes some of how an actor is drawn. */
export function setLook(id: ActorId, change: Partial<ActorLook>, label: string): Edit {
  return editActor(id, label, (actor) => ({ ...actor, look: { ...actor.look, ...change } }));
}
