import type { Character } from '../core/character.ts';
import { hasComputedNormals } from '../core/computed-normals.ts';
import { firstEqualFloats } from '../core/equal-tuples.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { computeVertexNormals, type FaceWeighting, type Weld } from '../core/vertex-normals.ts';
import { groupCoincident, partsSomewhere } from './coincident.ts';
import type { VertexStreams } from './method.ts';

/** The cosine of the angle at which two normals of a file differ by more than rounding. */
const creaseCosine = Math.cos(Math.PI / 180);

/**
 * Recomputes the normals of posed vertices from the faces around them.
 *
 * @param posed its normals are written
 */
export function recomputeNormals(
  character: Character,
  weighting: FaceWeighting,
  { positions, normals }: VertexStreams,
): void {
  computeVertexNormals(positions, character.mesh.indices, normals, weighting, weldOf(character));
}

/**
 * Finds the vertices of a character that have one normal in common although they are split: those at
 * one place in the bind pose, with weights alike, as along the seams of textures. The creases of a file's own normals stay.
 */
export function weldOf({ mesh, skin }: Pick<Character, 'mesh' | 'skin'>): Weld {
  let weld = welds.get(mesh);
  if (!weld) welds.set(mesh, (weld = findWeld(mesh, skin)));
  return weld;
}

const welds = new WeakMap<Mesh, Weld>();

function findWeld(mesh: Mesh, skin: Skin): Weld {
  const { indices, positions, normals, pointOf } = mesh;
  const hasCreases = !hasComputedNormals(mesh);
  const isApart = (a: number, b: number): boolean =>
    (hasCreases && cosine(normals, a * 3, b * 3) < creaseCosine) ||
    partsSomewhere(skin, pointOf[a]!, pointOf[b]!);
  const { groupOf, groupCount } = groupCoincident(firstEqualFloats(positions, 3), isApart);
  return {
    groupOf,
    corners: indices.map((vertex) => groupOf[vertex]!),
    sums: new Float64Array(groupCount * 3),
  };
}

function cosine(normals: Float32Array, a: number, b: number): number {
  return (
    normals[a]! * normals[b]! +
    normals[a + 1]! * normals[b + 1]! +
    normals[a + 2]! * normals[b + 2]!
  );
}
