import type { Character } from '../../core/character.ts';
import type { MaterialParts } from '../../core/character-parts.ts';

/** All triangles of one material. */
export interface MaterialRun {
  readonly material: MaterialParts;
  /** (triangleCount × 3) render vertices. */
  readonly corners: Uint32Array;
}

/**
 * Returns the triangles by material, because in the file those of a material are consecutive: first
 * the materials of the character, also those without triangles, then those that are only named.
 */
export function materialRuns({ mesh, materials }: Character): MaterialRun[] {
  const pieces = new Map<string, Uint32Array[]>();
  for (const { name } of materials) pieces.set(name, []);
  for (const { material, firstIndex, indexCount } of mesh.submeshes) {
    const piece = mesh.indices.subarray(firstIndex, firstIndex + indexCount);
    const others = pieces.get(material);
    if (others) others.push(piece);
    else pieces.set(material, [piece]);
  }
  const known = new Map(materials.map((material) => [material.name, material]));
  return Array.from(pieces, ([name, own]) => {
    return { material: known.get(name) ?? { name }, corners: joined(own) };
  });
}

export function joined(pieces: readonly Uint32Array[]): Uint32Array {
  const all = new Uint32Array(pieces.reduce((sum, { length }) => sum + length, 0));
  let next = 0;
  for (const piece of pieces) {
    all.set(piece, next);
    next += piece.length;
  }
  return all;
}
