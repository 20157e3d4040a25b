import type { MeshParts } from './character-parts.ts';
import { cornerNormals, cornerUvs, type CornerValues } from './corner-values.ts';
import { flushSubnormal } from './float32.ts';
import type { Mesh, Submesh } from './mesh.ts';
import { splitCorners, type SplitCorners } from './split-corners.ts';

/**
 * Packs loose corners into render vertices. A point is split only if its corners differ in texture
 * coordinate or normal. Every point gets a render vertex, even if no face uses it, so that skin
 * rows and posed files keep the file's order.
 */
export function buildMesh(parts: MeshParts): Mesh {
  const positions = parts.positions.map(flushSubnormal);
  const pointCount = positions.length / 3;
  const uvs = cornerUvs(parts);
  const normals = cornerNormals(parts, positions);
  const values = [...(uvs ? [uvs] : []), normals].map(({ ofCorner }) => ofCorner);
  const split = splitCorners(parts.cornerPoints, pointCount, values);
  return {
    pointCount,
    vertexCount: split.pointOf.length,
    pointOf: split.pointOf,
    positions: gather(positions, 3, split.pointOf),
    normals: valuesOfVertices(normals, 3, split),
    uvs: uvs ? valuesOfVertices(uvs, 2, split) : null,
    indices: split.indices,
    submeshes: packSubmeshes(parts),
  };
}

function valuesOfVertices(
  { values, ofCorner, ofPoint }: CornerValues,
  size: number,
  { cornerOf }: SplitCorners,
): Float32Array {
  // A render vertex without a corner is a point that no face uses.
  const chosen = new Int32Array(cornerOf.length);
  for (let vertex = 0; vertex < chosen.length; vertex++) {
    const corner = cornerOf[vertex]!;
    chosen[vertex] = corner === -1 ? ofPoint[vertex]! : ofCorner[corner]!;
  }
  return gather(values, size, chosen);
}

/** Copies the tuples of `size` at these indices, one after another. */
function gather(from: Float32Array, size: number, indices: Int32Array | Uint32Array): Float32Array {
  const packed = new Float32Array(indices.length * size);
  for (let target = 0; target < indices.length; target++) {
    const source = indices[target]! * size;
    for (let i = 0; i < size; i++) packed[target * size + i] = from[source + i]!;
  }
  return packed;
}

function packSubmeshes(parts: MeshParts): Submesh[] {
  const triangleCount = parts.cornerPoints.length / 3;
  const runs = parts.submeshes ?? [{ material: '', firstTriangle: 0 }];
  return runs
    .map(({ material, firstTriangle }, index) => {
      const end = runs[index + 1]?.firstTriangle ?? triangleCount;
      return { material, firstIndex: firstTriangle * 3, indexCount: (end - firstTriangle) * 3 };
    })
    .filter(({ indexCount }) => indexCount > 0);
}
