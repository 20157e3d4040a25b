import type { Mesh } from './mesh.ts';
import { computeVertexNormals } from './vertex-normals.ts';

/** Whether the normals are those that a reader computes for a file without any. */
export function hasComputedNormals(mesh: Mesh): boolean {
  const { pointCount, pointOf, positions, indices, normals } = mesh;
  const points = positions.subarray(0, pointCount * 3);
  const computed = new Float32Array(points.length);
  const cornerPoints = indices.map((vertex) => pointOf[vertex]!);
  computeVertexNormals(points, cornerPoints, computed);
  return normals.every((value, i) => {
    const vertex = Math.floor(i / 3);
    return value === computed[pointOf[vertex]! * 3 + (i % 3)];
  });
}
