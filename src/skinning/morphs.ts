import type { Mesh } from '../core/mesh.ts';
import type { Morph } from '../core/morph.ts';
import { flushSubnormal } from '../core/float32.ts';
import type { VertexStreams } from './method.ts';

const { fround } = Math;

/** Below this a blend of normals has no direction left; the mesh's own is put in its place. */
const smallestSquare = fround(1e-30);

/**
 * The mesh at rest with its morphs: `p = base + Σ s · offset`, normals likewise and made unit again
 * (CSE169, project 2). In float32, morphs in order, those of weight 0 left out; done before skinning.
 *
 * @param weights (morphCount) any number, 0 to 1 as a rule
 * @param out written for all render vertices
 */
export function addMorphs(
  mesh: Mesh,
  morphs: readonly Morph[],
  weights: ArrayLike<number>,
  out: VertexStreams,
): void {
  out.positions.set(mesh.positions);
  out.normals.set(mesh.normals);
  morphs.forEach((morph, index) => {
    const weight = fround(weights[index] ?? 0);
    if (weight === 0) return;
    addScaled(out.positions, morph.vertices, morph.offsets, weight);
    addScaled(out.normals, morph.normalVertices, morph.normalOffsets, weight);
  });
  morphs.forEach((morph, index) => {
    if (fround(weights[index] ?? 0) === 0) return;
    for (const vertex of morph.normalVertices) makeUnit(out.normals, mesh.normals, vertex * 3);
  });
}

/** The mesh with its morphs; the mesh itself where no weight is set. */
export function morphedMesh(
  mesh: Mesh,
  morphs: readonly Morph[],
  weights: ArrayLike<number>,
): Mesh {
  if (morphs.every((_, index) => (weights[index] ?? 0) === 0)) return mesh;
  const out = {
    positions: new Float32Array(mesh.positions.length),
    normals: new Float32Array(mesh.normals.length),
  };
  addMorphs(mesh, morphs, weights, out);
  return { ...mesh, ...out };
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

/** A normal that two morphs change comes here twice; the second time it is unit already. */
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
