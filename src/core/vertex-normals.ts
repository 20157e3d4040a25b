import { flushSubnormal } from './float32.ts';

/**
 * Computes unit normals at points from the triangles around them. Each triangle is weighted by the
 * angle of its corner, so that the result does not depend on how a polygon is triangulated (Thürmer
 * and Wüthrich 1998, "Computing vertex normals from polygonal facets"). A point without a proper
 * triangle gets +y, never NaN.
 *
 * @param positions (pointCount × 3)
 * @param triangles (triangleCount × 3) indices of points
 * @param normals (pointCount × 3) written
 */
export function computeVertexNormals(
  positions: Float32Array,
  triangles: Uint32Array,
  normals: Float32Array,
): void {
  const sums = new Float64Array(normals.length);
  for (let first = 0; first < triangles.length; first += 3) addTriangle(first);
  for (let i = 0; i < sums.length; i += 3) {
    const length = Math.hypot(sums[i]!, sums[i + 1]!, sums[i + 2]!);
    if (length > 0)
      for (let k = 0; k < 3; k++) normals[i + k] = flushSubnormal(sums[i + k]! / length);
    else normals.set([0, 1, 0], i);
  }

  function addTriangle(first: number): void {
    const [a, b, c] = [triangles[first]! * 3, triangles[first + 1]! * 3, triangles[first + 2]! * 3];
    const [abx, aby, abz] = edge(a, b);
    const [acx, acy, acz] = edge(a, c);
    const nx = aby * acz - abz * acy;
    const ny = abz * acx - abx * acz;
    const nz = abx * acy - aby * acx;
    const area = Math.hypot(nx, ny, nz);
    if (!(area > 0)) return;
    for (const [corner, next, previous] of [
      [a, b, c],
      [b, c, a],
      [c, a, b],
    ] as const) {
      const angle = angleAt(corner, next, previous);
      sums[corner] = sums[corner]! + (nx / area) * angle;
      sums[corner + 1] = sums[corner + 1]! + (ny / area) * angle;
      sums[corner + 2] = sums[corner + 2]! + (nz / area) * angle;
    }
  }

  function angleAt(corner: number, next: number, previous: number): number {
    const [ux, uy, uz] = edge(corner, next);
    const [vx, vy, vz] = edge(corner, previous);
    const cross = Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
    return Math.atan2(cross, ux * vx + uy * vy + uz * vz);
  }

  function edge(from: number, to: number): [number, number, number] {
    return [
      positions[to]! - positions[from]!,
      positions[to + 1]! - positions[from + 1]!,
      positions[to + 2]! - positions[from + 2]!,
    ];
  }
}
