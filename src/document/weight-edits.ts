import { assert } from '../core/assert.ts';
import { type Edit, editActor } from './edit.ts';
import type { ActorId } from './scene.ts';

/** Keeps the strongest influences of each point, or all of them (null). */
export function setInfluences(id: ActorId, influences: number | null): Edit {
  assert(influences === null || influences >= 1, 'at least one influence');
  const label = influences === null ? 'Keep all influences' : `Keep ${influences} influences`;
  return editActor(id, label, (actor) => ({ ...actor, influences }));
}
