import { type Bounds, emptyBounds, includePositions, isEmpty } from '../core/bounds.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Ray } from '../core/ray.ts';
import { noJoint, type Skin } from '../core/skin.ts';

/** Where a ray meets a skin. */
export interface SkinHit {
  /** The joint with the most weight there; null where the skin follows none. */
  readonly joint: number | null;
  /** Counts triples of `Mesh.indices`. */
  readonly triangle: number;
  /** What each corner of the triangle counts; they sum to 1. */
  readonly barycentric: readonly [number, number, number];
  /** Along the ray, in the character's units. */
  readonly distance: number;
}

/**
 * The nearest triangle that the ray meets, from either side, and the joint that owns that place
 * (Möller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection").
 *
 * Takes one pass over the vertices for their box, and one over the triangles where the ray meets it;
 * nothing is allocated on the way.
 *
 * @param positions (vertexCount × 3) as posed, character space
 * @param ray in the character's space
 */
export function pickSkin(
  mesh: Mesh,
  skin: Skin,
  positions: Float32Array,
  ray: Ray,
): SkinHit | null {
  const [ox, oy, oz] = [ray.origin[0], ray.origin[1], ray.origin[2]];
  const [dx, dy, dz] = [ray.direction[0], ray.direction[1], ray.direction[2]];
  if (!meetsBox(ray, boxOf(positions))) return null;
  const { indices } = mesh;
  let nearest = Infinity;
  let triangle = -1;
  let [second, third] = [0, 0];
  for (let i = 0; i < indices.length; i += 3) {
    const a = indices[i]! * 3;
    const b = indices[i + 1]! * 3;
    const c = indices[i + 2]! * 3;
    const [ax, ay, az] = [positions[a]!, positions[a + 1]!, positions[a + 2]!];
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
    if (determinant === 0) continue; // seen edge on, or without area
    const scale = 1 / determinant;
    const sx = ox - ax;
    const sy = oy - ay;
    const sz = oz - az;
    const u = (sx * px + sy * py + sz * pz) * scale;
    if (!(u >= 0 && u <= 1)) continue;
    const qx = sy * bz - sz * by;
    const qy = sz * bx - sx * bz;
    const qz = sx * by - sy * bx;
    const v = (dx * qx + dy * qy + dz * qz) * scale;
    if (!(v >= 0 && u + v <= 1)) continue;
    const distance = (cx * qx + cy * qy + cz * qz) * scale;
    if (!(distance >= 0 && distance < nearest)) continue;
    nearest = distance;
    triangle = i / 3;
    [second, third] = [u, v];
  }
  if (triangle === -1) return null;
  const barycentric = [1 - second - third, second, third] as const;
  return {
    joint: ownerOf(mesh, skin, triangle, barycentric),
    triangle,
    barycentric,
    distance: nearest,
  };
}

/** The joint whose weights, summed over the corners as they count, are the largest. */
function ownerOf(
  { indices, pointOf }: Mesh,
  skin: Skin,
  triangle: number,
  barycentric: readonly number[],
): number | null {
  const sums = new Map<number, number>();
  let owner = noJoint;
  barycentric.forEach((part, corner) => {
    const point = pointOf[indices[triangle * 3 + corner]!]!;
    for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
      const joint = skin.paletteJoint[skin.entries[i]!]!;
      sums.set(joint, (sums.get(joint) ?? 0) + part * skin.weights[i]!);
    }
  });
  let largest = -Infinity;
  for (const [joint, sum] of sums) {
    if (sum <= largest) continue;
    [owner, largest] = [joint, sum];
  }
  return owner === noJoint ? null : owner;
}

function boxOf(positions: Float32Array): Bounds {
  box.min.fill(Infinity);
  box.max.fill(-Infinity);
  includePositions(box, positions, positions.length / 3);
  return box;
}

/** The slab test (Kay and Kajiya 1986), generous by rounding: it only spares the triangles. */
function meetsBox({ origin, direction }: Ray, bounds: Bounds): boolean {
  if (isEmpty(bounds)) return false;
  let [enter, leave] = [0, Infinity];
  for (let axis = 0; axis < 3; axis++) {
    const [from, slope] = [origin[axis]!, direction[axis]!];
    const [low, high] = [bounds.min[axis]!, bounds.max[axis]!];
    const slack = 1e-9 * (Math.abs(low) + Math.abs(high) + Math.abs(from));
    if (slope === 0) {
      if (from < low - slack || from > high + slack) return false;
      continue;
    }
    const first = ((slope > 0 ? low : high) - from) / slope;
    const last = ((slope > 0 ? high : low) - from) / slope;
    const room = slack / Math.abs(slope);
    enter = Math.max(enter, first - room);
    leave = Math.min(leave, last + room);
  }
  return enter <= leave;
}

const box = emptyBounds();
