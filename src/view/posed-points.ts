import type { Actor } from '../document/scene.ts';
import type { SkinDevice } from '../document/session.ts';
import type { Viewer } from './viewer.ts';

/** Returns (pointCount × 3) posed positions of an actor, in the file's order and units. */
export function posedPoints(viewer: Viewer, actor: Actor, device: SkinDevice): Float32Array {
  const { positions } = viewer.skin(actor, device);
  return positions.slice(0, actor.character.mesh.pointCount * 3);
}
