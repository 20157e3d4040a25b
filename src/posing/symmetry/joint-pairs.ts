import { jointMatrices } from '../../core/forward-kinematics.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { pairByGeometry, type JointPlaces } from './pair-by-geometry.ts';
import { sidedName } from './name-sides.ts';

/** The entry of `partners` for a joint that has none. */
export const noPartner = -1;

/** Which joints of a character mirror each other. */
export interface JointPairs {
  /** (jointCount) the other joint of a pair; itself on the plane of symmetry; or `noPartner`. */
  readonly partners: Int16Array;
  /** (jointCount) 1 for the left joint of a pair, -1 for the right one, 0 for all others. */
  readonly sides: Int8Array;
  /** The plane of symmetry is x = this, in the character's space. */
  readonly plane: number;
  /**
   * (qCount) the pose in which the pairs are mirror images: the file's pose or, if it stands more
   * symmetrically so, all values at zero.
   */
  readonly reference: Float64Array;
}

/** A joint this near to the plane or to its mirror image, in diagonals of all joints, is there. */
const nearness = 0.02;

const known = new WeakMap<Skeleton, JointPairs>();

/** Finds the pairs by names and, where these tell nothing, by places and hierarchy. */
export function jointPairs(skeleton: Skeleton): JointPairs {
  let found = known.get(skeleton);
  if (!found) known.set(skeleton, (found = findPairs(skeleton)));
  return found;
}

function findPairs(skeleton: Skeleton): JointPairs {
  const named = pairByName(skeleton);
  const [atRest, atZero] = [skeleton.qRest, zeroPose(skeleton)].map((q) =>
    pairIn(skeleton, q, named),
  );
  return atZero!.mismatch < atRest!.mismatch - 1e-9 ? atZero!.pairs : atRest!.pairs;
}

/** A pairing, and how far the joints are from their mirror images: 0 if nothing could be better. */
interface RatedPairs {
  readonly pairs: JointPairs;
  readonly mismatch: number;
}

function pairIn(skeleton: Skeleton, reference: Float64Array, named: Int16Array): RatedPairs {
  const { jointCount, parents } = skeleton;
  const matrices = jointMatrices(skeleton, reference);
  const place = (joint: number, axis: number): number => matrices[joint * 16 + 12 + axis]!;
  const joints = Array.from(parents.keys());
  const middles = joints
    .filter((joint) => named[joint] !== noPartner)
    .map((joint) => (place(joint, 0) + place(named[joint]!, 0)) / 2);
  const roots = joints.filter((joint) => parents[joint] === -1).map((joint) => place(joint, 0));
  const plane = median(middles.length > 0 ? middles : roots);
  const extents = [0, 1, 2].map((axis) => {
    const values = joints.map((joint) => place(joint, axis));
    return Math.max(...values) - Math.min(...values);
  });
  const size = Math.hypot(...extents);
  const distance = (a: number, b: number): number =>
    Math.hypot(
      2 * plane - place(a, 0) - place(b, 0),
      place(a, 1) - place(b, 1),
      place(a, 2) - place(b, 2),
    );
  const isSided = joints.map((joint) => sideOf(skeleton, joint).side !== null);
  const places: JointPlaces = { parents, distance, isSided, tolerance: nearness * size };
  const partners = pairByGeometry(places, named);
  const hasPair = joints.some((joint) => isPaired(partners, joint));
  // Without any pair, joints off the plane say that this is no body with a left and a right.
  if (!hasPair && partners.includes(noPartner)) partners.fill(noPartner);
  const sum = joints.reduce((total, joint) => {
    const partner = partners[joint]!;
    const away = partner === noPartner ? Infinity : distance(joint, partner);
    return total + Math.min(away, places.tolerance);
  }, 0);
  const offset = (joint: number): number => place(joint, 0) - plane;
  return {
    pairs: { partners, sides: sidesOf(skeleton, partners, offset), plane, reference },
    mismatch: size > 0 ? sum / size / jointCount : 0,
  };
}

/** The joints whose names differ only by the side. */
function pairByName(skeleton: Skeleton): Int16Array {
  const partners = new Int16Array(skeleton.jointCount).fill(noPartner);
  const waiting = new Map<string, number[]>();
  skeleton.names.forEach((_, joint) => {
    const { side, stem } = sideOf(skeleton, joint);
    if (side === null) return;
    const other = waiting.get(`${side === 'left' ? 'right' : 'left'} ${stem}`)?.shift();
    if (other === undefined) {
      const key = `${side} ${stem}`;
      waiting.set(key, [...(waiting.get(key) ?? []), joint]);
    } else {
      partners[joint] = other;
      partners[other] = joint;
    }
  });
  return partners;
}

function sideOf({ names, englishNames }: Skeleton, joint: number): ReturnType<typeof sidedName> {
  const own = sidedName(names[joint]!);
  return own.side === null ? sidedName(englishNames?.[joint] ?? '') : own;
}

/**
 * The sides of all pairs: as their names say, otherwise by their places. The left is where the left
 * joints by name are, and at larger x without such, since characters look along z.
 *
 * @param offset the distance of a joint from the plane, along x
 */
function sidesOf(
  skeleton: Skeleton,
  partners: Int16Array,
  offset: (joint: number) => number,
): Int8Array {
  const sign = { left: 1, right: -1 } as const;
  const byName = skeleton.names.map((_, joint) => {
    const { side } = sideOf(skeleton, joint);
    return side === null || !isPaired(partners, joint) ? 0 : sign[side];
  });
  const leftward = byName.reduce<number>((sum, side, joint) => sum + side * offset(joint), 0);
  const sums = byName.map((_, joint) => offset(joint));
  for (let joint = sums.length - 1; joint > 0; joint--) {
    const parent = skeleton.parents[joint]!;
    if (parent >= 0) sums[parent]! += sums[joint]!;
  }
  return Int8Array.from(byName, (side, joint) => {
    if (side !== 0 || !isPaired(partners, joint)) return side;
    // A joint may lie in the plane although its branch does not, as hips do.
    const beyond = (sums[joint]! - sums[partners[joint]!]!) * (leftward < 0 ? -1 : 1);
    return beyond > 0 || (beyond === 0 && joint < partners[joint]!) ? 1 : -1;
  });
}

/** Whether a joint is one of a left and a right one. */
function isPaired(partners: Int16Array, joint: number): boolean {
  return partners[joint] !== noPartner && partners[joint] !== joint;
}

/** All values at zero, and balls without rotation. */
function zeroPose({ qRest, dofKind, dofQ }: Skeleton): Float64Array {
  const q = new Float64Array(qRest.length);
  dofKind.forEach((kind, dof) => {
    if (kind === DofKind.ball) q[dofQ[dof]! + 3] = 1;
  });
  return q;
}

function median(values: readonly number[]): number {
  const sorted = values.toSorted((a, b) => a - b);
  const middle = (sorted.length - 1) / 2;
  return sorted.length === 0 ? 0 : (sorted[Math.floor(middle)]! + sorted[Math.ceil(middle)]!) / 2;
}
