import { flushSubnormal } from '../core/float32.ts';
import type { Pose } from '../core/pose.ts';
import type { RestLayer } from './rest-layer.ts';

const { fround } = Math;

/** Below this a blend of normals has no direction left; the mesh's own is put in its place. */
const smallestSquare = fround(1e-30);

/**
 * Morph targets: `p = base + Σ s · offset`, normals likewise and made unit again (CSE169, project 2).
 * In float32, morphs in order, those of weight 0 left out. Weights are 0 to 1 as a rule, or any number.
 */
export const morphLayer: RestLayer = {
  id: 'morphs',
  isActive: ({ morphs }, pose) => morphs.some((_, index) => weightOf(pose, index) !== 0),
  addTo({ mesh, morphs }, pose, { positions, normals }) {
    const used = morphs
      .map((morph, index) => ({ morph, weight: weightOf(pose, index) }))
      .filter(({ weight }) => weight !== 0);
    for (const { morph, weight } of used) {
      addScaled(positions, morph.vertices, morph.offsets, weight);
      addScaled(normals, morph.normalVertices, morph.normalOffsets, weight);
    }
    for (const { morph } of used) {
      for (const vertex of morph.normalVertices) makeUnit(normals, mesh.normals, vertex * 3);
    }
  },
};

function weightOf({ morphWeights }: Pose, index: number): number {
  return fround(morphWeights?.[index] ?? 0);
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
