import type { SurfaceRings } from './surface-rings.ts';

/** A surface at rest with a frame at each place. */
export interface FramedSurface {
  /** (placeCount × 3) */
  readonly places: Float64Array;
  /**
   * (placeCount × 9) two unit tangents and the unit normal, one after the other; zeros where the
   * surface has no normal.
   */
  readonly frames: Float64Array;
}

/**
 * Sums of products of edges that are smaller than this part of the edges' squared lengths have no
 * direction left.
 */
const smallestPart = 1e-5;

/** Gives each place of a surface a frame. The direction of its tangents does not matter. */
export function frameSurface(rings: SurfaceRings, places: Float64Array): FramedSurface {
  const frames = new Float64Array(rings.placeCount * 9);
  for (let place = 0; place < rings.placeCount; place++) {
    if (!findNormal(rings, places, place)) continue;
    const nx = normal[0]!;
    const ny = normal[1]!;
    const nz = normal[2]!;
    // The axis that is the furthest from the normal gives the tangent.
    const isX = Math.abs(nx) <= Math.abs(ny) && Math.abs(nx) <= Math.abs(nz);
    const isY = !isX && Math.abs(ny) <= Math.abs(nz);
    const ax = isX ? 1 : 0;
    const ay = isY ? 1 : 0;
    const az = isX || isY ? 0 : 1;
    const along = ax * nx + ay * ny + az * nz;
    const length = Math.sqrt(1 - along * along);
    const tx = (ax - along * nx) / length;
    const ty = (ay - along * ny) / length;
    const tz = (az - along * nz) / length;
    const at = place * 9;
    frames[at] = tx;
    frames[at + 1] = ty;
    frames[at + 2] = tz;
    frames[at + 3] = ny * tz - nz * ty;
    frames[at + 4] = nz * tx - nx * tz;
    frames[at + 5] = nx * ty - ny * tx;
    frames[at + 6] = nx;
    frames[at + 7] = ny;
    frames[at + 8] = nz;
  }
  return { places, frames };
}

/**
 * Computes the rotation of a surface at one place, from rest to a pose. It takes the normal at rest
 * to the posed normal, and turns about it so that the edges at rest, projected onto the tangent
 * plane, come as close to the posed edges as they can, in the sense of least squares. No edge is
 * preferred, so that the rotation changes smoothly with the pose.
 *
 * @param posed (placeCount × 3)
 * @param turn (9) written, row by row
 * @returns whether there is a rotation; there is none where the faces or the edges around the place
 *   cancel or vanish, at rest or in the pose
 */
export function writeTurn(
  rings: SurfaceRings,
  rest: FramedSurface,
  posed: Float64Array,
  place: number,
  turn: Float64Array,
): boolean {
  const { frames } = rest;
  const frame = place * 9;
  if (frames[frame + 6] === 0 && frames[frame + 7] === 0 && frames[frame + 8] === 0) return false;
  if (!findNormal(rings, posed, place) || !findTangent(rings, rest, posed, place)) return false;
  for (let row = 0; row < 3; row++) {
    const t = tangent[row]!;
    const n = normal[row]!;
    const i = row === 2 ? 0 : row + 1;
    const j = row === 0 ? 2 : row - 1;
    const b = normal[i]! * tangent[j]! - normal[j]! * tangent[i]!;
    for (let column = 0; column < 3; column++) {
      const at = frame + column;
      turn[row * 3 + column] = t * frames[at]! + b * frames[at + 3]! + n * frames[at + 6]!;
    }
  }
  return true;
}

/** (3) the result of `findTangent`. */
const tangent = new Float64Array(3);

/**
 * Finds the posed tangent that belongs to the first one at rest, if the edges give one. With u and
 * v, the coordinates of each edge at rest along the two tangents, and the posed edge e, the best
 * unit tangent t across the posed normal n has the largest Σ u (t · e) + v ((n × t) · e), which is
 * t · (Σ u e + (Σ v e) × n).
 */
function findTangent(
  { ringStart, ring }: SurfaceRings,
  { places, frames }: FramedSurface,
  posed: Float64Array,
  place: number,
): boolean {
  const at = place * 3;
  const frame = place * 9;
  const tx = frames[frame]!;
  const ty = frames[frame + 1]!;
  const tz = frames[frame + 2]!;
  const bx = frames[frame + 3]!;
  const by = frames[frame + 4]!;
  const bz = frames[frame + 5]!;
  // Σ u e and Σ v e.
  let ux = 0;
  let uy = 0;
  let uz = 0;
  let vx = 0;
  let vy = 0;
  let vz = 0;
  let size = 0;
  for (let i = ringStart[place]!; i < ringStart[place + 1]!; i++) {
    const other = ring[i]! * 3;
    const dx = places[other]! - places[at]!;
    const dy = places[other + 1]! - places[at + 1]!;
    const dz = places[other + 2]! - places[at + 2]!;
    const ex = posed[other]! - posed[at]!;
    const ey = posed[other + 1]! - posed[at + 1]!;
    const ez = posed[other + 2]! - posed[at + 2]!;
    const u = dx * tx + dy * ty + dz * tz;
    const v = dx * bx + dy * by + dz * bz;
    ux += u * ex;
    uy += u * ey;
    uz += u * ez;
    vx += v * ex;
    vy += v * ey;
    vz += v * ez;
    size += Math.sqrt((dx * dx + dy * dy + dz * dz) * (ex * ex + ey * ey + ez * ez));
  }
  const nx = normal[0]!;
  const ny = normal[1]!;
  const nz = normal[2]!;
  const x = ux + vy * nz - vz * ny;
  const y = uy + vz * nx - vx * nz;
  const z = uz + vx * ny - vy * nx;
  const along = x * nx + y * ny + z * nz;
  const cx = x - along * nx;
  const cy = y - along * ny;
  const cz = z - along * nz;
  const length = Math.sqrt(cx * cx + cy * cy + cz * cz);
  if (!(length > size * smallestPart)) return false;
  tangent[0] = cx / length;
  tangent[1] = cy / length;
  tangent[2] = cz / length;
  return true;
}

/** The area of the faces around a place, as far as they face one way. */
export function faceArea(rings: SurfaceRings, places: Float64Array, place: number): number {
  sumFaces(rings, places, place);
  return Math.sqrt(faces[0]! ** 2 + faces[1]! ** 2 + faces[2]! ** 2) / 2;
}

/** Finds the unit mean of the normals of the faces around a place by area, if there is one. */
function findNormal(rings: SurfaceRings, places: Float64Array, place: number): boolean {
  sumFaces(rings, places, place);
  const length = Math.sqrt(faces[0]! ** 2 + faces[1]! ** 2 + faces[2]! ** 2);
  if (!(length > faces[3]! * smallestPart)) return false;
  normal[0] = faces[0]! / length;
  normal[1] = faces[1]! / length;
  normal[2] = faces[2]! / length;
  return true;
}

/** (3) the result of `findNormal`. */
const normal = new Float64Array(3);

/** (4) the result of `sumFaces`. */
const faces = new Float64Array(4);

/**
 * Sums the cross products of the triangles around a place, each of which is twice as long as its
 * area, and the squared lengths of half of their edges.
 */
function sumFaces({ fanStart, fan }: SurfaceRings, places: Float64Array, place: number): void {
  const at = place * 3;
  const x = places[at]!;
  const y = places[at + 1]!;
  const z = places[at + 2]!;
  let nx = 0;
  let ny = 0;
  let nz = 0;
  let squares = 0;
  for (let i = fanStart[place]! * 2; i < fanStart[place + 1]! * 2; i += 2) {
    const b = fan[i]! * 3;
    const c = fan[i + 1]! * 3;
    const bx = places[b]! - x;
    const by = places[b + 1]! - y;
    const bz = places[b + 2]! - z;
    const cx = places[c]! - x;
    const cy = places[c + 1]! - y;
    const cz = places[c + 2]! - z;
    nx += by * cz - bz * cy;
    ny += bz * cx - bx * cz;
    nz += bx * cy - by * cx;
    squares += bx * bx + by * by + bz * bz;
  }
  faces[0] = nx;
  faces[1] = ny;
  faces[2] = nz;
  faces[3] = squares;
}
