import { vec3 } from 'gl-matrix';

/** A posed surface, in the character's space. */
interface PosedSurface {
  /** (vertexCount × 3) whose first are the points */
  readonly positions: Float32Array;
  /** (vertexCount × 3) unit vectors */
  readonly normals: Float32Array;
  /** (triangleCount × 3) vertices */
  readonly indices: Uint32Array;
}

/** What a small picture of a surface shows: a square around a point, seen from a direction. */
interface SeenSquare {
  readonly middle: vec3;
  /** A unit vector towards the eye. */
  readonly direction: vec3;
  /** Half of the square's side, and how far the eye is, in model units. */
  readonly half: number;
  readonly distance: number;
}

/** The cells on a side of the square. */
const cells = 32;
/** So many sides of a cell a point may be behind what covers its cell, since cells are coarse. */
const tolerance = 2;

/** The nearest surface in each cell, as a distance towards the eye; one for all squares. */
const nearest = new Float32Array(cells * cells);

/**
 * Computes how well points are seen: the sum of their weights times the cosines under which they face
 * the eye, where nothing covers them and they are in the square, as a part of the sum of all weights.
 * The surface is drawn into coarse cells from a far eye, which is near enough to a long lens.
 *
 * @param weights (pointCount) not negative
 */
export function seenPart(surface: PosedSurface, weights: Float32Array, square: SeenSquare): number {
  const { positions, normals } = surface;
  const { direction, half } = square;
  const places = inSquare(positions, square);
  drawCells(surface.indices, places, square.distance);
  let [seen, all] = [0, 0];
  const behind = (tolerance * 2 * half) / cells;
  for (let point = 0, at = 0; point < weights.length; point++, at += 3) {
    const weight = weights[point]!;
    if (weight === 0) continue;
    all += weight;
    const cell = cellOf(places[at]!, places[at + 1]!);
    if (cell < 0 || places[at + 2]! < nearest[cell]! - behind) continue;
    const facing =
      normals[at]! * direction[0] +
      normals[at + 1]! * direction[1] +
      normals[at + 2]! * direction[2];
    if (facing > 0) seen += weight * facing;
  }
  return all > 0 ? seen / all : 0;
}

/** The array of the last surface, for the next square. */
let known = new Float32Array(0);

/** (vertexCount × 3) across and down in cells, and towards the eye from the middle in model units. */
function inSquare(positions: Float32Array, { middle, direction, half }: SeenSquare): Float32Array {
  const right = vec3.cross(new Float64Array(3), [0, 1, 0], direction);
  if (vec3.length(right) < 1e-6) vec3.set(right, 1, 0, 0);
  vec3.normalize(right, right);
  const up = vec3.cross(new Float64Array(3), direction, right);
  const scale = cells / (2 * half);
  if (known.length < positions.length) known = new Float32Array(positions.length);
  const places = known;
  const rightX = right[0];
  const rightY = right[1];
  const rightZ = right[2];
  const upX = up[0];
  const upY = up[1];
  const upZ = up[2];
  const towardsX = direction[0];
  const towardsY = direction[1];
  const towardsZ = direction[2];
  for (let at = 0; at < positions.length; at += 3) {
    const x = positions[at]! - middle[0];
    const y = positions[at + 1]! - middle[1];
    const z = positions[at + 2]! - middle[2];
    places[at] = cells / 2 + scale * (x * rightX + y * rightY + z * rightZ);
    places[at + 1] = cells / 2 + scale * (x * upX + y * upY + z * upZ);
    places[at + 2] = x * towardsX + y * towardsY + z * towardsZ;
  }
  return places;
}

function cellOf(x: number, y: number): number {
  return x >= 0 && y >= 0 && x < cells && y < cells ? Math.floor(y) * cells + Math.floor(x) : -1;
}

/** Finds what is nearest to the eye in each cell, of triangles that are not behind it. */
function drawCells(indices: Uint32Array, places: Float32Array, distance: number): void {
  nearest.fill(-Infinity);
  for (let corner = 0; corner < indices.length; corner += 3) {
    const a = indices[corner]! * 3;
    const b = indices[corner + 1]! * 3;
    const c = indices[corner + 2]! * 3;
    const ax = places[a]!;
    const ay = places[a + 1]!;
    const bx = places[b]! - ax;
    const by = places[b + 1]! - ay;
    const cx = places[c]! - ax;
    const cy = places[c + 1]! - ay;
    const area = bx * cy - by * cx;
    const right = ax + Math.max(0, bx, cx);
    const top = ay + Math.max(0, by, cy);
    if (area === 0 || right < 0 || top < 0) continue;
    const left = ax + Math.min(0, bx, cx);
    const bottom = ay + Math.min(0, by, cy);
    if (left >= cells || bottom >= cells) continue;
    const az = places[a + 2]!;
    const bz = places[b + 2]!;
    const cz = places[c + 2]!;
    if (!(Math.max(az, bz, cz) < distance)) continue;
    const lastRow = Math.min(cells - 1, Math.floor(top));
    const lastColumn = Math.min(cells - 1, Math.floor(right));
    for (let row = Math.max(0, Math.floor(bottom)); row <= lastRow; row++) {
      for (let column = Math.max(0, Math.floor(left)); column <= lastColumn; column++) {
        // The middle of the cell in barycentric coordinates.
        const x = column + 0.5 - ax;
        const y = row + 0.5 - ay;
        const u = (x * cy - y * cx) / area;
        const v = (y * bx - x * by) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        const depth = az + u * (bz - az) + v * (cz - az);
        const cell = row * cells + column;
        if (depth > nearest[cell]!) nearest[cell] = depth;
      }
    }
  }
}
