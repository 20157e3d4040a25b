import type { Character } from '../../src/core/character.ts';

/** The corners of the triangles of each material, in the order of the materials. */
export function trianglesOf({ mesh, materials }: Character): number[][] {
  const runs = new Map<string, number[]>(materials.map(({ name }) => [name, []]));
  for (const { material, firstIndex, indexCount } of mesh.submeshes) {
    const run = runs.get(material) ?? [];
    for (const corner of mesh.indices.subarray(firstIndex, firstIndex + indexCount)) {
      run.push(corner); // too many for one call
    }
    runs.set(material, run);
  }
  return [...runs.values()];
}
