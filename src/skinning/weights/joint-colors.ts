import { colorDifference, type Lab, labOf } from '../../core/color-difference.ts';
import { bytesOf, displayable, encodedChannel, linearOf, type Triple } from '../../core/oklab.ts';
import { noParent, type Skeleton } from '../../core/skeleton.ts';
import { dichromacies, seenAs } from './color-vision.ts';

type Tree = Pick<Skeleton, 'jointCount' | 'parents'>;

export interface JointColors {
  /** (jointCount × 3) sRGB bytes. */
  readonly bytes: Uint8Array;
  /** (jointCount) the hue of each joint, in degrees of OKLab's circle; no two are equal. */
  readonly hues: Float64Array;
}

/** The sectors of the circle of hues, and the lightnesses, from which colors are chosen. */
const sectorCount = 36;
const lightnesses = [0.4, 0.5, 0.6, 0.7, 0.8, 0.9] as const;
const chroma = 0.17;
const choiceCount = sectorCount * lightnesses.length;
/** How little of a difference from a joint two edges away, but for siblings, counts as much. */
const farPart = 0.6;
/** Only so many siblings on each side are compared, since no eye tells hundreds of colors apart. */
const nearestSiblings = 12;
/** How many joints more than its even share a sector may have. */
const room = 1;
/** Joints that differ less than this from a neighbor (CIEDE2000) choose again, round by round. */
const [enough, rounds] = [22, 5];
/** A difference that is as good as any larger one. */
const plenty = 40;

/**
 * Gives each joint a color with a hue of its own, as unlike as possible to those of its parent, its
 * children, its siblings and what is two edges up or down: the difference is CIEDE2000, the least
 * of that for full color vision and for the three dichromacies. Joints choose one after another,
 * depth first; then those that are too much like a neighbor choose again. Equal trees get equal
 * colors. A thousand joints take about a tenth of a second.
 */
export function jointColors(tree: Tree): JointColors {
  const { jointCount } = tree;
  const relatives = relativesOf(tree);
  const chosen = new Int16Array(jointCount).fill(-1);
  const users = new Uint16Array(sectorCount);
  const mostUsers = Math.ceil(jointCount / sectorCount) + room;
  /** The least difference of a joint of this color from its relatives that have one. */
  const scoreOf = (joint: number, choice: number): number => {
    let least = Infinity;
    for (const { other, part } of relatives[joint]!) {
      if (chosen[other] === -1) continue;
      least = Math.min(least, difference(choice, chosen[other]!) / part);
    }
    return least;
  };
  const choose = (joint: number): void => {
    const former = chosen[joint]!;
    if (former !== -1) users[sectorOf(former)]!--;
    let [best, largest] = [former, -Infinity];
    for (let choice = 0; choice < choiceCount; choice++) {
      const count = users[sectorOf(choice)]!;
      if (choice !== former && count >= mostUsers) continue;
      const least = scoreOf(joint, choice);
      // Of what differs enough, hues that no joint is near are better.
      const score =
        least < enough ? least : enough + (Math.min(least, plenty) - enough) / (1 + count);
      if (score > largest) [best, largest] = [choice, score];
    }
    chosen[joint] = best;
    users[sectorOf(best)]!++;
  };
  for (let joint = 0; joint < jointCount; joint++) choose(joint);
  for (let round = 0; round < rounds; round++) {
    for (let joint = 0; joint < jointCount; joint++) {
      if (scoreOf(joint, chosen[joint]!) < enough) choose(joint);
    }
  }
  return colorsOf(chosen, users);
}

/** The colors of a skeleton's joints, which are computed when they are first shown. */
export function jointColorsOf(skeleton: Skeleton): JointColors {
  let colors = held.get(skeleton);
  if (!colors) held.set(skeleton, (colors = jointColors(skeleton)));
  return colors;
}

const held = new WeakMap<Skeleton, JointColors>();

interface Relative {
  readonly other: number;
  readonly part: number;
}

function relativesOf({ jointCount, parents }: Tree): readonly (readonly Relative[])[] {
  const relatives = Array.from({ length: jointCount }, (): Relative[] => []);
  const lastChildren = new Map<number, number[]>();
  const relate = (a: number, b: number, part: number): void => {
    relatives[a]!.push({ other: b, part });
    relatives[b]!.push({ other: a, part });
  };
  for (let joint = 0; joint < jointCount; joint++) {
    const parent = parents[joint]!;
    if (parent !== noParent) {
      relate(joint, parent, 1);
      if (parents[parent]! !== noParent) relate(joint, parents[parent]!, farPart);
    }
    const siblings = lastChildren.get(parent) ?? [];
    for (const sibling of siblings) relate(joint, sibling, 1);
    lastChildren.set(parent, [...siblings, joint].slice(-nearestSiblings));
  }
  return relatives;
}

function sectorOf(choice: number): number {
  return choice % sectorCount;
}

function hueOf(choice: number, within = 0): number {
  return ((sectorOf(choice) + within) * 360) / sectorCount;
}

function colorAt(choice: number, hue: number) {
  return displayable({ lightness: lightnesses[Math.floor(choice / sectorCount)]!, chroma, hue });
}

/** The joints of one sector divide it evenly. */
function colorsOf(chosen: Int16Array, users: Uint16Array): JointColors {
  const ranks = new Uint16Array(sectorCount);
  const hues = Float64Array.from(chosen, (choice) => {
    const sector = sectorOf(choice);
    return hueOf(choice, ranks[sector]!++ / users[sector]!);
  });
  const bytes = Uint8Array.from(
    [...hues].flatMap((hue, joint) => bytesOf(colorAt(chosen[joint]!, hue))),
  );
  return { bytes, hues };
}

/** Each choice as seen by eyes of each kind, once it was asked for. */
const seen: (readonly Lab[])[] = [];
/** (choiceCount × choiceCount) what `difference` returned; NaN where it was not asked yet. */
let known: Float32Array | null = null;

/** The difference of two choices to the eyes that tell them apart the least. */
function difference(a: number, b: number): number {
  known ??= new Float32Array(choiceCount * choiceCount).fill(NaN);
  const place = Math.max(a, b) * choiceCount + Math.min(a, b);
  if (Number.isNaN(known[place])) {
    const [one, other] = [seenBy(a), seenBy(b)];
    known[place] = Math.min(...one.map((lab, eye) => colorDifference(lab, other[eye]!)));
  }
  return known[place]!;
}

function seenBy(choice: number): readonly Lab[] {
  return (seen[choice] ??= eyes(linearOf(colorAt(choice, hueOf(choice)))));
}

function eyes(light: Triple): readonly Lab[] {
  return [light, ...dichromacies.map((each) => seenAs(each, light))].map((each) => {
    const [r, g, b] = each.map((channel) => 255 * encodedChannel(channel));
    return labOf([r!, g!, b!]);
  });
}
