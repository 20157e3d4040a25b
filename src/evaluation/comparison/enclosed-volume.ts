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
  const [ox, oy, oz] = [positions[apex]!, positions[apex + 1]!, positions[apex + 2]!];
  let six = 0;
  for (let at = 0; at < corners.length; at += 3) {
    const [a, b, c] = [corners[at]! * 3, corners[at + 1]! * 3, corners[at + 2]! * 3];
    const [ax, ay, az] = [positions[a]! - ox, positions[a + 1]! - oy, positions[a + 2]! - oz];
    const [bx, by, bz] = [positions[b]! - ox, positions[b + 1]! - oy, positions[b + 2]! - oz];
    const [cx, cy, cz] = [positions[c]! - ox, positions[c + 1]! - oy, positions[c + 2]! - oz];
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
    const [a, b, c] = [corners[at]! * 3, corners[at + 1]! * 3, corners[at + 2]! * 3];
    const [ax, ay, az] = [positions[a]!, positions[a + 1]!, positions[a + 2]!];
    const [ux, uy, uz] = [positions[b]! - ax, positions[b + 1]! - ay, positions[b + 2]! - az];
    const [vx, vy, vz] = [positions[c]! - ax, positions[c + 1]! - ay, positions[c + 2]! - az];
    twice += Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
  }
  return twice / 2;
}
