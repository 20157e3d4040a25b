import { flushSubnormal } from './float32.ts';

const up = [0, 1, 0];

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
  for (let first = 0; first < triangles.length; first += 3) {
    addTriangle(triangles[first]! * 3, triangles[first + 1]! * 3, triangles[first + 2]! * 3);
  }
  for (let i = 0; i < sums.length; i += 3) {
    const length = lengthOf(sums[i]!, sums[i + 1]!, sums[i + 2]!);
    if (length > 0)
      for (let k = 0; k < 3; k++) normals[i + k] = flushSubnormal(sums[i + k]! / length);
    else normals.set(up, i);
  }

  // No arrays are taken apart here, because code that is still cold does create them.
  function addTriangle(a: number, b: number, c: number): void {
    const ax = positions[a]!;
    const ay = positions[a + 1]!;
    const az = positions[a + 2]!;
    const bx = positions[b]!;
    const by = positions[b + 1]!;
    const bz = positions[b + 2]!;
    const cx = positions[c]!;
    const cy = positions[c + 1]!;
    const cz = positions[c + 2]!;
    const abx = bx - ax;
    const aby = by - ay;
    const abz = bz - az;
    const bcx = cx - bx;
    const bcy = cy - by;
    const bcz = cz - bz;
    const cax = ax - cx;
    const cay = ay - cy;
    const caz = az - cz;
    const nx = abz * cay - aby * caz;
    const ny = abx * caz - abz * cax;
    const nz = aby * cax - abx * cay;
    const area = lengthOf(nx, ny, nz);
    if (!(area > 0)) return;
    // The sine of each corner's angle times its two edges is the area, the cosine times them a dot product.
    add(a, nx, ny, nz, Math.atan2(area, -(abx * cax + aby * cay + abz * caz)) / area);
    add(b, nx, ny, nz, Math.atan2(area, -(bcx * abx + bcy * aby + bcz * abz)) / area);
    add(c, nx, ny, nz, Math.atan2(area, -(cax * bcx + cay * bcy + caz * bcz)) / area);
  }

  function add(point: number, x: number, y: number, z: number, weight: number): void {
    sums[point] = sums[point]! + x * weight;
    sums[point + 1] = sums[point + 1]! + y * weight;
    sums[point + 2] = sums[point + 2]! + z * weight;
  }
}

/** Squares of what a float32 holds, and of products of two of them, are well within a double. */
function lengthOf(x: number, y: number, z: number): number {
  return Math.sqrt(x * x + y * y + z * z);
}
