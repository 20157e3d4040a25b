import { type Actor, actorById } from './scene.ts';
import type { Session } from './session.ts';
import type { Store } from './store.ts';

/**
 * The actor that panels and keys act on, or none in an empty scene. Reading it subscribes to store
 * and session.
 */
export function selectedActor(
  { scene }: Pick<Store, 'scene'>,
  { selectedActorId }: Session,
): Actor | undefined {
  return actorById(scene.value, selectedActorId.value);
}
