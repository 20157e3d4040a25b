import type { Edit } from './edit.ts';
import type { Actor, Scene } from './scene.ts';

/** Replaces the scene and all that is in it. */
export function replaceScene(scene: Scene, label: string): Edit {
  return { label, apply: () => scene };
}

/** Adds actors in the order of their ids. */
export function addActors(actors: readonly Actor[], label: string): Edit {
  return {
    label,
    apply: (scene) => ({
      ...scene,
      actors: [...scene.actors, ...actors].toSorted((a, b) => a.id - b.id),
    }),
  };
}
