import type { Character } from '../core/character.ts';
import { noJoint } from '../core/skin.ts';

/** Both of two joints move a point by at least this weight. */
const sharedWeight = 0.05;

/** The joint that moves the most points together with its parent, or null if none shares any. */
export function sharingJoint({ skeleton, skin }: Character): number | null {
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
  const most = Math.max(0, ...counts);
  return most === 0 ? null : counts.indexOf(most);
}
