import { jointRange } from '../../core/pose.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import { jointPairs, type JointPairs, noPartner } from './joint-pairs.ts';
import { mirrorFrames } from './mirror-frames.ts';
import { transformMirror } from './mirror-transform.ts';
import { type JointMirror, valueMirror } from './mirror-values.ts';

/** The symmetry of a character: its pairs, and how the pose of one joint becomes that of the other. */
export interface Symmetry extends JointPairs {
  readonly skeleton: Skeleton;
  /** (jointCount) how each joint is mirrored onto its partner; null without one. */
  readonly mirrors: readonly (JointMirror | null)[];
}

/** A mirrored pose. */
export interface MirroredPose {
  /** (qCount) */
  readonly q: Float64Array;
  /** The joints that are not exactly mirrored, because their limits or hinges do not allow it. */
  readonly stopped: readonly number[];
  /** The joints that were to be mirrored, but have no partner. */
  readonly alone: readonly number[];
}

const known = new WeakMap<Skeleton, Symmetry>();

/** Finds the symmetry of a character, at the first call for a skeleton. */
export function symmetryOf(skeleton: Skeleton): Symmetry {
  let found = known.get(skeleton);
  if (!found) known.set(skeleton, (found = findSymmetry(skeleton)));
  return found;
}

function findSymmetry(skeleton: Skeleton): Symmetry {
  const pairs = jointPairs(skeleton);
  const { partners, reference } = pairs;
  const turnOf = mirrorFrames(skeleton, reference);
  const mirrors = Array.from(partners, (partner, joint) => {
    if (partner === noPartner) return null;
    const both = [joint, partner] as const;
    const turn = turnOf(joint, partner);
    return (
      valueMirror(skeleton, both, turn, reference) ??
      transformMirror(skeleton, both, turn, reference)
    );
  });
  return { ...pairs, skeleton, mirrors };
}

/** How far a mirrored value may be from what the partner can do, in radians or model units. */
const slack = 1e-9;

/**
 * Returns a pose in which the partners of some joints have the mirrored rotations, and for roots the
 * mirrored places, of these joints in another pose. A rotation is mirrored as it is in the
 * character's space with all joints above at rest, so that mirroring all joints mirrors the figure.
 * Values end at their limits.
 *
 * @param from (qCount) the pose that is mirrored
 * @param onto (qCount) the pose that keeps all other values
 * @param joints those whose partners are set; a joint on the plane is its own
 */
export function mirrorJoints(
  { skeleton, partners, mirrors }: Symmetry,
  from: Float64Array,
  onto: Float64Array,
  joints: Iterable<number>,
): MirroredPose {
  const q = onto.slice();
  const stopped: number[] = [];
  const alone: number[] = [];
  for (const joint of joints) {
    const mirror = mirrors[joint];
    const partner = partners[joint]!;
    if (!mirror) alone.push(joint);
    else if (!setMirrored(skeleton, mirror, partner, from, q)) stopped.push(partner);
  }
  return { q, stopped, alone };
}

/** Sets the values of a partner, and returns whether it can have them. */
function setMirrored(
  skeleton: Skeleton,
  mirror: JointMirror,
  partner: number,
  from: Float64Array,
  q: Float64Array,
): boolean {
  const { qMin, qMax } = skeleton;
  const [start, end] = jointRange(skeleton, partner);
  let isWithin = mirror(from, q);
  for (let i = start; i < end; i++) {
    const value = Math.min(Math.max(q[i]!, qMin[i]!), qMax[i]!);
    if (Math.abs(value - q[i]!) > slack) isWithin = false;
    q[i] = value;
  }
  return isWithin;
}
