import { loadPart } from '../core/failure.ts';
import type { Actor } from '../document/scene.ts';
import { LazyPart } from '../evaluation/lazy-part.ts';

/** Reports that what covers a surface is loaded, or why it can't be shown. */
export type OnImage = (name: string, fault: string | null) => void;

/** The code for textures and for other covers of surfaces, which the first picture may not need. */
export const dressCode = new LazyPart(
  async () => (await loadPart(import('./dress/actor-dress.ts'))).ActorDress,
);

/** Whether anything covers surfaces of an actor. */
export function needsDress({ character, look }: Actor): boolean {
  return character.images.length > 0 || !/file|clay/.test(look.surface);
}
