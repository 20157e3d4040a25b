import type { Character } from '../core/character.ts';
import { noJoint } from '../core/skin.ts';

/** Both of two joints move a point by at least this weight. */
const sharedWeight = 0.05;

/** The joints that move points together with their parents, those with the most points first. */
export function sharingJoints({ skeleton, skin }: Character): readonly number[] {
  const { start, entries, weights, paletteJoint } = skin;
  const counts = new Uint32Array(skeleton.jointCount);
  for (let point = 0; point + 1 < start.length; point++) {
    const joints = new Set<number>();
    for (let i = start[point]!; i < start[point + 1]!; i++) {
      const joint = paletteJoint[entries[i]!]!;
      if (weights[i]! >= sharedWeight && joint !== noJoint) joints.add(joint);
    }
    for (const joint of joints) if (joints.has(skeleton.parents[joint]!)) counts[joint]!++;
  }
  const sharing = [...counts.keys()].filter((joint) => counts[joint]! > 0);
  return sharing.sort((a, b) => counts[b]! - counts[a]! || a - b);
}
