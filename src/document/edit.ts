import type { Actor, ActorId, Scene } from './scene.ts';

/** An edit: a pure function from scene to scene, with a name for the Undo button. */
export interface Edit {
  readonly label: string;
  apply(scene: Scene): Scene;
}

/** An edit of one actor. */
export function editActor(id: ActorId, label: string, edit: (actor: Actor) => Actor): Edit {
  return {
    label,
    apply: (scene) => ({
      ...scene,
      actors: scene.actors.map((actor) => (actor.id === id ? edit(actor) : actor)),
    }),
  };
}
