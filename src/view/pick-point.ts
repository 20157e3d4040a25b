import { selectedActor } from '../document/selected-actor.ts';
import { pickSkin } from '../posing/pick-skin.ts';
import { characterRayAt, type Looking, type PickPlace } from './pick.ts';
import { posedTriangles } from './posed-triangles.ts';

/**
 * Returns the point of the selected actor's mesh whose part of the skin is at a place of the view:
 * of the triangle there, the corner with the largest barycentric weight. Null if there is no skin.
 */
export function pointAt(look: Looking, place: PickPlace): number | null {
  const actor = selectedActor(look.store, look.session);
  const shown = actor && look.evaluations.of(actor, place.overrides);
  if (!shown?.state.look.visible || !look.session.showSkin.value) return null;
  const { mesh } = shown.state.character;
  const hit = pickSkin(mesh, shown.skin, posedTriangles(shown), characterRayAt(look, place));
  if (!hit) return null;
  const corner = hit.barycentric.indexOf(Math.max(...hit.barycentric));
  return mesh.pointOf[mesh.indices[hit.triangle * 3 + corner]!]!;
}
