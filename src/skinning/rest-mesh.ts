import { flushSubnormal } from '../core/float32.ts';
import type { Character } from '../core/character.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Pose } from '../core/pose.ts';
import { morphLayer } from './morphs.ts';
import type { RestLayer } from './rest-layer.ts';

const { fround } = Math;

/** Every rest layer, in the order of application. */
const restLayers: readonly RestLayer[] = [morphLayer];

/**
 * A blended normal with a smaller squared length has no direction left; the mesh's own normal
 * replaces it.
 */
const smallestSquare = fround(1e-30);

/** The inputs of the mesh at rest, compared by identity. */
export function restKey(character: Character, pose: Pose): readonly unknown[] {
  return restLayers.flatMap((layer) => layer.key(character, pose));
}

/**
 * Returns the mesh that is skinned: the character's own, or a copy to which the terms of the rest
 * layers have been added in float32, one after the other. Its normals are normalized again.
 */
export function restMesh(character: Character, pose: Pose): Mesh {
  const { mesh } = character;
  const terms = restLayers.flatMap((layer) => layer.terms(character, pose));
  if (terms.length === 0) return mesh;
  const [positions, normals] = [mesh.positions.slice(), mesh.normals.slice()];
  for (const { vertices, offsets, normalVertices, normalOffsets, weight } of terms) {
    addScaled(positions, vertices, offsets, weight);
    addScaled(normals, normalVertices, normalOffsets, weight);
  }
  for (const { normalVertices } of terms) {
    for (const vertex of normalVertices) makeUnit(normals, mesh.normals, vertex * 3);
  }
  return { ...mesh, positions, normals };
}

function addScaled(
  values: Float32Array,
  vertices: Uint32Array,
  offsets: Float32Array,
  weight: number,
): void {
  for (let index = 0; index < vertices.length; index++) {
    const at = vertices[index]! * 3;
    for (let i = 0; i < 3; i++) {
      const sum = fround(values[at + i]! + fround(weight * offsets[index * 3 + i]!));
      values[at + i] = flushSubnormal(sum);
    }
  }
}

/** A normal that two terms change is visited twice; the second time it already has unit length. */
function makeUnit(normals: Float32Array, base: Float32Array, at: number): void {
  const [x, y, z] = [normals[at]!, normals[at + 1]!, normals[at + 2]!];
  const squared = fround(fround(fround(x * x) + fround(y * y)) + fround(z * z));
  if (!(squared > smallestSquare)) {
    for (let i = 0; i < 3; i++) normals[at + i] = base[at + i]!;
    return;
  }
  const scale = fround(1 / fround(Math.sqrt(squared)));
  normals[at] = flushSubnormal(fround(x * scale));
  normals[at + 1] = flushSubnormal(fround(y * scale));
  normals[at + 2] = flushSubnormal(fround(z * scale));
}
