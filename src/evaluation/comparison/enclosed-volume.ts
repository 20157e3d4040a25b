/**
 * The volume inside a closed surface, by the divergence theorem: the sum of the signed volumes of
 * tetrahedra between each triangle and one point, here a corner of the surface, so that few digits
 * cancel.
 *
 * @param positions (vertexCount × 3)
 * @param corners (triangleCount × 3) vertices, counterclockwise seen from outside
 * @returns in cubic units of the positions; negative if the triangles face inwards
 */
export function enclosedVolume(positions: Float32Array, corners: Uint32Array): number {
  const apex = corners.length > 0 ? corners[0]! * 3 : 0;
  const ox = positions[apex]!;
  const oy = positions[apex + 1]!;
  const oz = positions[apex + 2]!;
  let six = 0;
  for (let at = 0; at < corners.length; at += 3) {
    const a = corners[at]! * 3;
    const b = corners[at + 1]! * 3;
    const c = corners[at + 2]! * 3;
    const ax = positions[a]! - ox;
    const ay = positions[a + 1]! - oy;
    const az = positions[a + 2]! - oz;
    const bx = positions[b]! - ox;
    const by = positions[b + 1]! - oy;
    const bz = positions[b + 2]! - oz;
    const cx = positions[c]! - ox;
    const cy = positions[c + 1]! - oy;
    const cz = positions[c + 2]! - oz;
    six += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return six / 6;
}

/**
 * @param positions (vertexCount × 3)
 * @param corners (triangleCount × 3) vertices
 * @returns in square units of the positions
 */
export function surfaceArea(positions: Float32Array, corners: Uint32Array): number {
  let twice = 0;
  for (let at = 0; at < corners.length; at += 3) {
    const a = corners[at]! * 3;
    const b = corners[at + 1]! * 3;
    const c = corners[at + 2]! * 3;
    const ux = positions[b]! - positions[a]!;
    const uy = positions[b + 1]! - positions[a + 1]!;
    const uz = positions[b + 2]! - positions[a + 2]!;
    const vx = positions[c]! - positions[a]!;
    const vy = positions[c + 1]! - positions[a + 1]!;
    const vz = positions[c + 2]! - positions[a + 2]!;
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    twice += Math.sqrt(x * x + y * y + z * z);
  }
  return twice / 2;
}
