import { mat4 } from 'gl-matrix';
import type { Character } from '../../core/character.ts';
import { noJoint, type Skin } from '../../core/skin.ts';
import { encodeLines, writeFloat32, writeFloat64 } from '../text/write-number.ts';
import { oneWord } from './write-skel.ts';

/**
 * Writes a `.skin` with a row per render vertex, so that a point that was split at a seam becomes
 * several vertices. It has one material and, if the mesh has weights, these and a binding matrix
 * per joint.
 */
export function writeSkin({ mesh, skin, materials, skeleton }: Character): Uint8Array {
  const lines: string[] = [];
  section('positions', rows(mesh.positions, 3));
  section('normals', rows(mesh.normals, 3));
  if (mesh.uvs) section('texcoords', rows(mesh.uvs, 2));
  const weighted = !skin.paletteJoint.includes(noJoint);
  if (weighted)
    section(
      'skinweights',
      Array.from(mesh.pointOf, (point) => weightRow(skin, point)),
    );
  for (const { name, texture } of materials) {
    lines.push(`material ${oneWord(name)}`.trimEnd() + ' {');
    if (texture !== undefined) lines.push(`\ttexture ${oneWord(texture)}`);
    lines.push('}');
  }
  section('triangles', rows(mesh.indices, 3, String));
  if (weighted) {
    section(
      'bindings',
      Array.from({ length: skeleton.jointCount }, (_, joint) => binding(joint)),
    );
  }
  return encodeLines(lines);

  function section(name: string, content: readonly string[]): void {
    lines.push(`${name} ${content.length} {`);
    for (const line of content) lines.push(`\t${line}`); // too many for one call
    lines.push('}');
  }

  function binding(joint: number): string {
    const entry = skin.paletteJoint.indexOf(joint);
    const bind = bindMatrix(skin, entry);
    const columns = [0, 1, 2, 3].map((column) => {
      return Array.from(bind.subarray(column * 4, column * 4 + 3), writeFloat64).join(' ');
    });
    return ['matrix {', ...columns.map((column) => `\t\t${column}`), '\t}'].join('\n');
  }
}

/**
 * The joint's frame at bind time: the file's own matrix, or else the inverse of `jointFromBind`.
 */
export function bindMatrix({ bindFromJoint, jointFromBind }: Skin, entry: number): Float64Array {
  const range = [entry * 16, entry * 16 + 16] as const;
  if (bindFromJoint) return bindFromJoint.subarray(...range);
  const bind = new Float64Array(16);
  mat4.invert(bind, jointFromBind.subarray(...range));
  return bind;
}

function weightRow({ start, entries, weights, paletteJoint }: Skin, point: number): string {
  const influences: string[] = [];
  for (let i = start[point]!; i < start[point + 1]!; i++) {
    influences.push(`${paletteJoint[entries[i]!]!} ${writeFloat32(weights[i]!)}`);
  }
  return [influences.length, ...influences].join(' ');
}

function rows(
  values: Float32Array | Uint32Array,
  size: number,
  write: (value: number) => string = writeFloat32,
): string[] {
  return Array.from({ length: values.length / size }, (_, row) =>
    Array.from(values.subarray(row * size, row * size + size), write).join(' '),
  );
}
