import type { Mesh } from '../core/mesh.ts';
import type { Ray } from '../core/ray.ts';
import { noJoint, type Skin } from '../core/skin.ts';
import type { TriangleTree } from './triangle-tree.ts';

/** The intersection of a ray and a skin. */
export interface SkinHit {
  /** The joint with the largest weight at that point, or null if the skin follows no joint. */
  readonly joint: number | null;
  /** Index of the triangle: it counts triples of `Mesh.indices`. */
  readonly triangle: number;
  /** Weights of the triangle's corners; they sum to 1. */
  readonly barycentric: readonly [number, number, number];
  /** Distance along the ray, in the character's units. */
  readonly distance: number;
}

/**
 * Returns the nearest triangle that the ray hits, from either side, and the joint with the largest
 * weight there.
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

/**
 * The joint with the largest weight, summed over the corners with their barycentric weights; null if
 * the skin there follows no joint.
 */
export function ownerOf(
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
