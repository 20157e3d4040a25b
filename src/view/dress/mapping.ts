import { vec3 } from 'gl-matrix';
import { emptyBounds, extents, includePositions, isEmpty } from '../../core/bounds.ts';
import type { Mesh } from '../../core/mesh.ts';
import type { ActorLook, Projection } from '../../document/actor-look.ts';

/** The size of what a checker repeats, as in mesh-mapped.frag.glsl. */
const checks = 20;

/** Where projections stand in the bind pose. */
export interface Mapping {
  /** The middle of the character's floor, in model units. */
  readonly origin: vec3;
  /** Its height, in model units. */
  readonly height: number;
}

/**
 * Returns where an image is projected. The bind pose has this place, and not the pose or the shape at
 * rest, so that the image moves with the skin and with morphs.
 */
export function mappingOf(mesh: Mesh): Mapping {
  let found = mappings.get(mesh);
  if (!found) mappings.set(mesh, (found = findMapping(mesh)));
  return found;
}

const mappings = new WeakMap<Mesh, Mapping>();

function findMapping({ positions, vertexCount }: Mesh): Mapping {
  const bounds = emptyBounds();
  includePositions(bounds, positions, vertexCount);
  if (isEmpty(bounds)) return { origin: [0, 0, 0], height: 1 };
  const { min, max } = bounds;
  const origin = vec3.lerp(new Float64Array(3), min, max, 0.5);
  origin[1] = min[1]!;
  return { origin, height: Math.max(...extents(bounds)) || 1 };
}

/** The projection that is used: a mesh without texture coordinates has none by them. */
export function projectionOf(
  { uvs }: Mesh,
  { projection }: Pick<ActorLook, 'projection'>,
): Projection {
  return uvs || projection !== 'uv' ? projection : 'box';
}

/** The side of one check of a checker: in model units, or by texture coordinates in those. */
export function checkSize(mesh: Mesh, look: Pick<ActorLook, 'projection' | 'repeats'>): number {
  const whole = projectionOf(mesh, look) === 'uv' ? 1 : mappingOf(mesh).height;
  return whole / (checks * look.repeats);
}
