import { jointMatrices } from '../../core/forward-kinematics.ts';
import type { Character } from '../../core/character.ts';
import type { Skin } from '../../core/skin.ts';
import { subtreeEnd } from '../../core/subtree.ts';

/** A point is shared where both sides of a joint have at least this weight in it. */
const sharedWeight = 0.05;

/**
 * Returns how far the part of the skin that bends with a joint goes: the distance from the joint of the
 * farthest point that the joints above it and it (with those below) share, at rest in model units. It
 * is 0 where they share none.
 */
export function jointReach({ skeleton, mesh }: Character, skin: Skin, joint: number): number {
  const { start, entries, weights, paletteJoint } = skin;
  const end = subtreeEnd(skeleton, joint);
  const at = jointMatrices(skeleton, skeleton.qRest).subarray(joint * 16 + 12, joint * 16 + 15);
  let reach = 0;
  for (let point = 0; point + 1 < start.length; point++) {
    let [inside, outside] = [0, 0];
    for (let i = start[point]!; i < start[point + 1]!; i++) {
      const owner = paletteJoint[entries[i]!]!;
      if (owner >= joint && owner < end) inside += weights[i]!;
      else outside += weights[i]!;
    }
    if (inside < sharedWeight || outside < sharedWeight) continue;
    const [x, y, z] = [0, 1, 2].map((axis) => mesh.positions[point * 3 + axis]! - at[axis]!);
    reach = Math.max(reach, Math.hypot(x!, y!, z!));
  }
  return reach;
}
