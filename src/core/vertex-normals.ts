import { flushSubnormal } from './float32.ts';

/** How much a face counts at a point: all alike, by its area, or by the angle of its corner. */
export type FaceWeighting = 'faces' | 'area' | 'angle';

/** Which vertices have one normal in common. */
export interface Weld {
  /** (vertexCount) */
  readonly groupOf: Uint32Array;
  /** (triangleCount × 3) the group of each corner. */
  readonly corners: Uint32Array;
  /** (groupCount × 3) overwritten, so that no call allocates an array. */
  readonly sums: Float64Array;
}

/**
 * Computes unit normals of points from the triangles around them. With weights by angle, the result
 * does not depend on how a polygon is triangulated (Thürmer and Wüthrich 1998, "Computing vertex
 * normals from polygonal facets"). A point without a proper triangle gets +y, never NaN.
 *
 * @param positions (pointCount × 3)
 * @param triangles (triangleCount × 3) indices of points
 * @param normals (pointCount × 3) written
 * @param weld points that share their triangles; none if absent
 */
export function computeVertexNormals(
  positions: Float32Array,
  triangles: Uint32Array,
  normals: Float32Array,
  weighting: FaceWeighting = 'angle',
  weld?: Weld,
): void {
  const { groupOf, corners = triangles, sums = new Float64Array(normals.length) } = weld ?? {};
  sums.fill(0);
  for (let first = 0; first < triangles.length; first += 3) addTriangle(first);
  for (let i = 0; i < normals.length; i += 3) {
    const at = groupOf ? groupOf[i / 3]! * 3 : i;
    const length = lengthOf(sums[at]!, sums[at + 1]!, sums[at + 2]!);
    for (let k = 0; k < 3; k++) {
      normals[i + k] = length > 0 ? flushSubnormal(sums[at + k]! / length) : k & 1;
    }
  }

  // No arrays are taken apart here, because code that is still cold does create them.
  function addTriangle(first: number): void {
    const a = triangles[first]! * 3;
    const b = triangles[first + 1]! * 3;
    const c = triangles[first + 2]! * 3;
    const ax = positions[a]!;
    const ay = positions[a + 1]!;
    const az = positions[a + 2]!;
    const abx = positions[b]! - ax;
    const aby = positions[b + 1]! - ay;
    const abz = positions[b + 2]! - az;
    const cax = ax - positions[c]!;
    const cay = ay - positions[c + 1]!;
    const caz = az - positions[c + 2]!;
    const nx = abz * cay - aby * caz;
    const ny = abx * caz - abz * cax;
    const nz = aby * cax - abx * cay;
    const area = lengthOf(nx, ny, nz);
    if (!(area > 0)) return;
    let atA = 1;
    let atB = 1;
    let atC = 1;
    if (weighting === 'angle') {
      const bcx = positions[c]! - positions[b]!;
      const bcy = positions[c + 1]! - positions[b + 1]!;
      const bcz = positions[c + 2]! - positions[b + 2]!;
      // The sine of each corner's angle times its two edges is the area, the cosine times them a
      // dot product.
      atA = Math.atan2(area, -(abx * cax + aby * cay + abz * caz));
      atB = Math.atan2(area, -(bcx * abx + bcy * aby + bcz * abz));
      atC = Math.atan2(area, -(cax * bcx + cay * bcy + caz * bcz));
    }
    const scale = weighting === 'area' ? 1 : area;
    add(first, nx, ny, nz, atA / scale);
    add(first + 1, nx, ny, nz, atB / scale);
    add(first + 2, nx, ny, nz, atC / scale);
  }

  function add(corner: number, x: number, y: number, z: number, weight: number): void {
    const at = corners[corner]! * 3;
    sums[at] = sums[at]! + x * weight;
    sums[at + 1] = sums[at + 1]! + y * weight;
    sums[at + 2] = sums[at + 2]! + z * weight;
  }
}

/** Squares of what a float32 holds, and of products of two of them, are well within a double. */
function lengthOf(x: number, y: number, z: number): number {
  return Math.sqrt(x * x + y * y + z * z);
}
