import { hasComputedNormals } from '../../core/computed-normals.ts';
import type { Mesh } from '../../core/mesh.ts';
import { encodeLines, writeFloat32 } from '../text/write-number.ts';
import { materialText } from './material-text.ts';

/** A mesh in another pose. */
interface PosedMesh {
  /** (at least pointCount × 3) */
  readonly positions: Float32Array;
  /** (vertexCount × 3), or null to write none. */
  readonly normals: Float32Array | null;
}

/**
 * Writes a mesh as OBJ with points in file order, its texture coordinates and materials, and its
 * normals if they differ from those that a reader computes from the faces.
 *
 * @param posed the points in another pose, with the normals to write, if any
 * @param library the file with the colors and textures of its materials
 */
export function writeObj(mesh: Mesh, posed?: PosedMesh, library?: string): Uint8Array {
  const positions = posed?.positions ?? mesh.positions;
  const normals = posed ? posed.normals : hasComputedNormals(mesh) ? null : mesh.normals;
  const lines = library === undefined ? [] : [`mtllib ${materialText(library)}`];
  for (let point = 0; point < mesh.pointCount; point++) {
    lines.push(`v ${tuple(positions, point, 3)}`);
  }
  const uvOf = mesh.uvs && writeValues('vt', mesh.uvs, 2, lines);
  const normalOf = normals && writeValues('vn', normals, 3, lines);
  for (const [run, { material, firstIndex, indexCount }] of mesh.submeshes.entries()) {
    const name = materialText(material);
    // `usemtl` without a name, for faces without a material after faces with one.
    if (name !== '' || run > 0) lines.push(`usemtl ${name}`.trimEnd());
    for (let i = firstIndex; i < firstIndex + indexCount; i += 3) {
      const [a, b, c] = [mesh.indices[i]!, mesh.indices[i + 1]!, mesh.indices[i + 2]!];
      lines.push(`f ${corner(a)} ${corner(b)} ${corner(c)}`);
    }
  }
  return encodeLines(lines);

  function corner(vertex: number): string {
    const point = mesh.pointOf[vertex]! + 1;
    const uv = uvOf ? `${uvOf[vertex]!}` : '';
    if (normalOf) return `${point}/${uv}/${normalOf[vertex]!}`;
    return uv === '' ? `${point}` : `${point}/${uv}`;
  }
}

/** Adds a line for each different value and gives each vertex its index. */
function writeValues(
  keyword: string,
  values: Float32Array,
  size: number,
  lines: string[],
): number[] {
  const numbers = new Map<string, number>();
  return Array.from({ length: values.length / size }, (_, vertex) => {
    const text = tuple(values, vertex, size);
    let number = numbers.get(text);
    if (number === undefined) {
      numbers.set(text, (number = numbers.size + 1));
      lines.push(`${keyword} ${text}`);
    }
    return number;
  });
}

function tuple(values: Float32Array, index: number, size: number): string {
  return Array.from(values.subarray(index * size, index * size + size), writeFloat32).join(' ');
}
