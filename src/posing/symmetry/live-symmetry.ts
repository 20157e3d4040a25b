import { jointRange } from '../../core/pose.ts';
import { noPartner } from './joint-pairs.ts';
import { mirrorJoints, type Symmetry } from './symmetry.ts';

/** Completes one pose after another of a gesture; each result is a new array. */
export type PoseCompletion = (edited: Float64Array) => Float64Array;

/**
 * Returns what keeps the two sides symmetrical during one gesture: where it changes one joint of a
 * pair, the other one gets the mirrored rotation. Joints on the plane stay free, and so does a pair
 * of which the gesture changes both joints, unless both lead.
 *
 * @param base (qCount) the pose at which the gesture began
 * @param leads joints whose partners follow although they are changed too, the first one before the
 *   others
 */
export function liveSymmetry(
  symmetry: Symmetry,
  base: Float64Array,
  leads: readonly number[] = [],
): PoseCompletion {
  const { skeleton, partners } = symmetry;
  let last = base;
  let followers: readonly number[] = [];
  const isSame = (joint: number, a: Float64Array, b: Float64Array): boolean => {
    const [from, to] = jointRange(skeleton, joint);
    for (let i = from; i < to; i++) if (a[i] !== b[i]) return false;
    return true;
  };
  return (edited) => {
    const given = edited.slice();
    // A tool edits either the pose of the start or the one that is shown, in which the followers
    // have moved already.
    for (const joint of followers) {
      const [from, to] = jointRange(skeleton, joint);
      if (isSame(joint, edited, last)) given.set(base.subarray(from, to), from);
    }
    const leaders: number[] = [];
    for (const [joint, partner] of partners.entries()) {
      if (partner === noPartner || partner === joint || isSame(joint, given, base)) continue;
      const place = leads.indexOf(joint);
      const isBefore = place >= 0 && place < leads.indexOf(partner);
      if (isBefore || isSame(partner, given, base)) leaders.push(joint);
    }
    followers = leaders.map((joint) => partners[joint]!);
    last = mirrorJoints(symmetry, given, given, leaders).q;
    return last;
  };
}
