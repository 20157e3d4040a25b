import type { Ray } from './ray.ts';

/** The intersection of a ray and a triangle. */
export interface TriangleMeeting {
  /** Distance along the ray, in units of its direction's length. */
  distance: number;
  /** Barycentric weight of the second and of the third corner; the first has the rest of 1. */
  second: number;
  third: number;
}

/**
 * Tests whether a ray hits a triangle, from either side (Möller and Trumbore 1997, "Fast, minimum
 * storage ray/triangle intersection"). Nothing is allocated.
 *
 * @param positions xyz triples
 * @param a where the first corner starts in `positions`; `b` and `c` likewise
 * @param meeting written if the ray hits
 */
export function rayTriangle(
  { origin, direction }: Ray,
  positions: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
  meeting: TriangleMeeting,
): boolean {
  const [dx, dy, dz] = [direction[0], direction[1], direction[2]];
  const ax = positions[a]!;
  const ay = positions[a + 1]!;
  const az = positions[a + 2]!;
  const bx = positions[b]! - ax;
  const by = positions[b + 1]! - ay;
  const bz = positions[b + 2]! - az;
  const cx = positions[c]! - ax;
  const cy = positions[c + 1]! - ay;
  const cz = positions[c + 2]! - az;
  const px = dy * cz - dz * cy;
  const py = dz * cx - dx * cz;
  const pz = dx * cy - dy * cx;
  const determinant = bx * px + by * py + bz * pz;
  if (determinant === 0) return false; // the triangle is seen edge-on or has no area
  const scale = 1 / determinant;
  const sx = origin[0] - ax;
  const sy = origin[1] - ay;
  const sz = origin[2] - az;
  const second = (sx * px + sy * py + sz * pz) * scale;
  if (!(second >= 0 && second <= 1)) return false;
  const qx = sy * bz - sz * by;
  const qy = sz * bx - sx * bz;
  const qz = sx * by - sy * bx;
  const third = (dx * qx + dy * qy + dz * qz) * scale;
  if (!(third >= 0 && second + third <= 1)) return false;
  const distance = (cx * qx + cy * qy + cz * qz) * scale;
  if (!(distance >= 0)) return false;
  meeting.distance = distance;
  meeting.second = second;
  meeting.third = third;
  return true;
}
