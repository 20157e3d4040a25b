import type { Mesh } from '../../core/mesh.ts';
import { encodeLines, writeFloat32 } from '../text/write-number.ts';

/**
 * Writes a mesh as OBJ, points in file order, with its texture coordinates and materials.
 *
 * @param positions (at least pointCount × 3) the points, posed or not
 */
export function writeObj(mesh: Mesh, positions: Float32Array = mesh.positions): Uint8Array {
  const lines: string[] = [];
  for (let point = 0; point < mesh.pointCount; point++) {
    lines.push(`v ${tuple(positions, point, 3)}`);
  }
  const corner = mesh.uvs ? writeUvs(mesh, mesh.uvs, lines) : (vertex: number) => point(vertex);
  for (const [run, { material, firstIndex, indexCount }] of mesh.submeshes.entries()) {
    if (material !== '') lines.push(`usemtl ${material}`);
    else if (run > 0) lines.push('usemtl'); // faces without material after faces with one
    for (let i = firstIndex; i < firstIndex + indexCount; i += 3) {
      const [a, b, c] = [mesh.indices[i]!, mesh.indices[i + 1]!, mesh.indices[i + 2]!];
      lines.push(`f ${corner(a)} ${corner(b)} ${corner(c)}`);
    }
  }
  return encodeLines(lines);

  function point(vertex: number): string {
    return String(mesh.pointOf[vertex]! + 1);
  }
}

/** Adds `vt` lines, equal ones once, and tells how a corner is then written. */
function writeUvs(mesh: Mesh, uvs: Float32Array, lines: string[]): (vertex: number) => string {
  const numbers = new Map<string, number>();
  const uvOf = Array.from({ length: mesh.vertexCount }, (_, vertex) => {
    const text = tuple(uvs, vertex, 2);
    let number = numbers.get(text);
    if (number === undefined) {
      numbers.set(text, (number = numbers.size + 1));
      lines.push(`vt ${text}`);
    }
    return number;
  });
  return (vertex) => `${mesh.pointOf[vertex]! + 1}/${uvOf[vertex]!}`;
}

function tuple(values: Float32Array, index: number, size: number): string {
  return Array.from(values.subarray(index * size, index * size + size), writeFloat32).join(' ');
}
