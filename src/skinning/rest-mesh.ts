import type { Character } from '../core/character.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Pose } from '../core/pose.ts';
import { morphLayer } from './morphs.ts';
import type { RestLayer } from './rest-layer.ts';

/** Every rest layer, in the order of application. */
const restLayers: readonly RestLayer[] = [morphLayer];

/** The mesh that is skinned: the character's own, or a copy with what the rest layers add. */
export function restMesh(character: Character, pose: Pose): Mesh {
  const { mesh } = character;
  const active = restLayers.filter((layer) => layer.isActive(character, pose));
  if (active.length === 0) return mesh;
  const rest = { positions: mesh.positions.slice(), normals: mesh.normals.slice() };
  for (const layer of active) layer.addTo(character, pose, rest);
  return { ...mesh, ...rest };
}
