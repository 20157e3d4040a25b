import { vec3 } from 'gl-matrix';
import type { Skeleton } from '../../core/skeleton.ts';
import type { Side } from '../symmetry/name-sides.ts';
import { jointPairs } from '../symmetry/joint-pairs.ts';
import type { NamedRoles } from './name-roles.ts';
import type { JointRole } from './roles.ts';

/** A limb of one side, from the first joint beside the middle of the body to its last. */
interface Limb {
  readonly joints: readonly number[];
  /** How far each joint is from the limb's beginning, along the limb. */
  readonly distances: readonly number[];
  /** How far its end is below its beginning. */
  readonly drop: number;
}

/** An elbow and a knee are between these parts of their limb's length. */
const middle = [0.35, 0.65] as const;

/** A leg leads down by at least this part of its length. */
const steep = 0.8;

/**
 * Finds arms and legs by their shape where names tell none: of the limbs that pair on both sides, the
 * leg is the one that leads down the farthest, and the arm the longest one that begins above. In both,
 * the joint nearest to half of the length bends.
 */
export function shapedRoles(
  skeleton: Skeleton,
  places: readonly vec3[],
  named: NamedRoles,
): NamedRoles {
  const hasLimbs = named.roles.some((role) => role === 'elbow' || role === 'knee');
  if (named.isOtherBody || hasLimbs) return named;
  const { partners, sides } = jointPairs(skeleton);
  const limbs = limbsOf(skeleton, places, sides);
  const [leg] = limbs
    .filter(({ drop, distances }) => drop > steep * distances.at(-1)!)
    .sort((a, b) => b.drop - a.drop);
  if (!leg) return named;
  const hipHeight = places[leg.joints[0]!]![1];
  const [arm] = limbs
    .filter((limb) => limb !== leg && places[limb.joints[0]!]![1] > hipHeight)
    .sort((a, b) => b.distances.at(-1)! - a.distances.at(-1)!);
  // Four legs or six would be as many limbs that lead down.
  const isTall = limbs.filter(({ drop }) => drop > 0.7 * leg.drop).length === 1;
  if (!arm || !isTall) return named;
  const roles = [...named.roles];
  const found: (Side | null)[] = [...named.sides];
  for (const [limb, names] of [
    [leg, ['hip', 'knee', 'ankle', 'toe']],
    [arm, ['shoulder', 'elbow', 'wrist']],
  ] as const) {
    const bend = bendOf(limb);
    if (bend < 1) return named;
    names.forEach((role: JointRole, i) => {
      const joint = limb.joints[bend - 1 + i];
      const partner = joint === undefined ? -1 : partners[joint]!;
      if (joint === undefined || partner < 0) return;
      for (const each of [joint, partner]) {
        roles[each] = role;
        found[each] = sides[each]! > 0 ? 'left' : 'right';
      }
    });
  }
  return { ...named, roles, sides: found };
}

/** The limbs of the left side; of joints at the same place, the last counts. */
function limbsOf(
  { parents, jointCount }: Skeleton,
  places: readonly vec3[],
  sides: Int8Array,
): Limb[] {
  const limbs: Limb[] = [];
  for (let first = 0; first < jointCount; first++) {
    const parent = parents[first]!;
    if (sides[first] !== 1 || (parent >= 0 && sides[parent] === 1)) continue;
    const path = longestPath(parents, places, first);
    const joints = path.filter(
      (joint, i) =>
        i === path.length - 1 || vec3.distance(places[joint]!, places[path[i + 1]!]!) > 1e-8,
    );
    let length = 0;
    const distances = joints.map((joint, i) => {
      if (i > 0) length += vec3.distance(places[joint]!, places[joints[i - 1]!]!);
      return length;
    });
    const drop = places[joints[0]!]![1] - places[joints.at(-1)!]![1];
    if (joints.length >= 3) limbs.push({ joints, distances, drop });
  }
  return limbs;
}

/** The path to the leaf that is farthest along the limb. */
function longestPath(parents: Int16Array, places: readonly vec3[], first: number): number[] {
  const lengths = new Map([[first, 0]]);
  for (let joint = first + 1; joint < parents.length; joint++) {
    const above = lengths.get(parents[joint]!);
    if (above === undefined) continue;
    lengths.set(joint, above + vec3.distance(places[joint]!, places[parents[joint]!]!));
  }
  const [[end]] = [...lengths].sort((a, b) => b[1] - a[1]) as [[number, number]];
  const path = [end];
  while (path[0] !== first) path.unshift(parents[path[0]!]!);
  return path;
}

/** The index of the joint that bends a limb, or -1. */
function bendOf({ distances }: Limb): number {
  const length = distances.at(-1)!;
  const parts = distances.map((distance) => distance / length);
  const best = parts.reduce(
    (near, part, i) => (Math.abs(part - 0.5) < Math.abs(parts[near]! - 0.5) ? i : near),
    0,
  );
  return parts[best]! >= middle[0] && parts[best]! <= middle[1] ? best : -1;
}
