import type { Skin } from '../core/skin.ts';

/**
 * Two vertices at one place whose weights differ by more than this, summed over all joints, part
 * in some pose, as lips do.
 */
const seamWeights = 0.1;

/** Things at one place, which are in one group unless they are kept apart. */
export interface Coincident {
  /** (n) */
  readonly groupOf: Uint32Array;
  readonly groupCount: number;
}

/**
 * Groups what is at one place.
 *
 * @param first (n) for each, the first one at the same place
 * @param isApart whether the second one can't join the group that the first one began
 */
export function groupCoincident(
  first: Int32Array,
  isApart: (leader: number, other: number) => boolean,
): Coincident {
  const groupOf = new Uint32Array(first.length);
  /** The one that began each group. */
  const leaders: number[] = [];
  /** The group after each one that begins at the same place; 0 after the last. */
  const following: number[] = [];
  for (let each = 0; each < first.length; each++) {
    if (first[each] === each) {
      groupOf[each] = begin(each);
      continue;
    }
    let group = groupOf[first[each]!]!;
    while (isApart(leaders[group]!, each)) {
      if (following[group] === 0) following[group] = begin(each);
      group = following[group]!;
    }
    groupOf[each] = group;
  }
  return { groupOf, groupCount: leaders.length };

  function begin(leader: number): number {
    following.push(0);
    return leaders.push(leader) - 1;
  }
}

/** Whether two points that coincide have weights so different that they part in some pose. */
export function partsSomewhere(skin: Skin, a: number, b: number): boolean {
  return weightDifference(skin, a, b) > seamWeights;
}

/** The sum over all joints of the differences between the weights of two points. */
function weightDifference(skin: Skin, a: number, b: number): number {
  if (a === b) return 0;
  let sum = 0;
  for (let i = skin.start[a]!; i < skin.start[a + 1]!; i++) {
    sum += Math.abs(skin.weights[i]! - weightOf(skin, b, skin.entries[i]!));
  }
  for (let i = skin.start[b]!; i < skin.start[b + 1]!; i++) {
    if (weightOf(skin, a, skin.entries[i]!) === 0) sum += Math.abs(skin.weights[i]!);
  }
  return sum;
}

function weightOf(skin: Skin, point: number, entry: number): number {
  let sum = 0;
  for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
    if (skin.entries[i] === entry) sum += skin.weights[i]!;
  }
  return sum;
}
