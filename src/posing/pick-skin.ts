import type { Mesh } from '../core/mesh.ts';
import type { Ray } from '../core/ray.ts';
import { noJoint, type Skin } from '../core/skin.ts';
import type { TriangleTree } from './triangle-tree.ts';

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
 * The nearest triangle that the ray meets, from either side, and the joint that owns that place.
 *
 * @param tree of the mesh, fitted to the pose
 * @param ray in the character's space
 */
export function pickSkin(mesh: Mesh, skin: Skin, tree: TriangleTree, ray: Ray): SkinHit | null {
  const hit = tree.nearest(ray);
  if (!hit) return null;
  const { triangle, distance, second, third } = hit;
  const barycentric = [1 - second - third, second, third] as const;
  return { joint: ownerOf(mesh, skin, triangle, barycentric), triangle, barycentric, distance };
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
