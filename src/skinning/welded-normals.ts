import type { Character } from '../core/character.ts';
import { hasComputedNormals } from '../core/computed-normals.ts';
import { firstEqualFloats } from '../core/equal-tuples.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { computeVertexNormals, type FaceWeighting, type Weld } from '../core/vertex-normals.ts';
import type { VertexStreams } from './method.ts';

/**
 * Two vertices at one place whose weights differ by more than this, summed over all joints, part
 * in some pose, as lips do, and have a normal each.
 */
const seamWeights = 0.1;
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
  const { vertexCount, indices } = mesh;
  const first = firstEqualFloats(mesh.positions, 3);
  const hasCreases = !hasComputedNormals(mesh);
  const groupOf = new Uint32Array(vertexCount);
  /** The vertex that began each group. */
  const leaders: number[] = [];
  /** The group after each one that begins at the same place; 0 after the last. */
  const following: number[] = [];
  for (let vertex = 0; vertex < vertexCount; vertex++) {
    if (first[vertex] === vertex) {
      groupOf[vertex] = begin(vertex);
      continue;
    }
    let group = groupOf[first[vertex]!]!;
    while (!isSeam(leaders[group]!, vertex)) {
      if (following[group] === 0) following[group] = begin(vertex);
      group = following[group]!;
    }
    groupOf[vertex] = group;
  }
  return {
    groupOf,
    corners: indices.map((vertex) => groupOf[vertex]!),
    sums: new Float64Array(leaders.length * 3),
  };

  function begin(vertex: number): number {
    following.push(0);
    return leaders.push(vertex) - 1;
  }

  function isSeam(a: number, b: number): boolean {
    if (a === b) return true;
    if (hasCreases && cosine(mesh.normals, a * 3, b * 3) < creaseCosine) return false;
    return weightDifference(skin, mesh.pointOf[a]!, mesh.pointOf[b]!) <= seamWeights;
  }
}

function cosine(normals: Float32Array, a: number, b: number): number {
  return (
    normals[a]! * normals[b]! +
    normals[a + 1]! * normals[b + 1]! +
    normals[a + 2]! * normals[b + 2]!
  );
}

/** The sum over all joints of the differences between the weights of two points. */
function weightDifference(skin: Skin, a: number, b: number): number {
  if (a === b) return 0;
  let sum = 0;
  for (let i = skin.start[a]!; i < skin.start[a + 1]!; i++) {
    sum += Math.abs(skin.weights[i]! - weightOf(skin, b, skin.entries[i]!));
  }
  for (let i = skin.start[b]!; i < skin.start[b + 1]!; i++) {
    if (weightOf(skin, a, skin.entries[i]!) === 0) sum += Math.abs(skin.weights[i]!);
  }
  return sum;
}

function weightOf(skin: Skin, point: number, entry: number): number {
  let sum = 0;
  for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
    if (skin.entries[i] === entry) sum += skin.weights[i]!;
  }
  return sum;
}
