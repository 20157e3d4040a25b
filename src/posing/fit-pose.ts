import { jointRange, type Pose } from '../core/pose.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { isTriple, type Quaternion, rotationOf, tripleAnglesOf } from './joint-rotation.ts';
import {
  dofLetters,
  heightOf,
  type NamedJoint,
  type NamedPose,
  type PosedThing,
} from './named-pose.ts';

/** A pose by name as one character takes it. */
export interface FittedPose {
  readonly pose: Required<Pose>;
  /** The joints that take values, in the order of the skeleton. */
  readonly joints: readonly number[];
  /** The names of joints and morphs that the character does not have. */
  readonly missing: readonly string[];
  /** The names of joints that can't take all that the pose has for them, or have limits to it. */
  readonly partly: readonly string[];
}

/** How far a value of a pose may be from what a joint takes, without being lost. */
const tolerance = 1e-9;

/**
 * Puts a named pose onto what a character shows. Joints and morphs that it does not name keep their
 * bits. A joint with the same degrees of freedom takes the values as they are, and one with others
 * the same rotation; values beyond its limits are clamped.
 *
 * @param shown what the character shows now
 */
export function fitPose(thing: PosedThing, shown: Required<Pose>, named: NamedPose): FittedPose {
  const { skeleton, morphs, bounds } = thing;
  const pose = { q: shown.q.slice(), morphWeights: shown.morphWeights.slice() };
  const jointOf = finder(skeleton.names, skeleton.englishNames);
  const morphOf = finder(morphs.map(({ name }) => name));
  const [height, from] = [heightOf(bounds), named.height];
  const scale = height > 0 && from > 0 && height !== from ? height / from : 1;
  const joints = new Set<number>();
  const missing: string[] = [];
  const partly: string[] = [];
  for (const given of named.joints) {
    const joint = jointOf(given.name);
    if (joint === undefined) missing.push(given.name);
    else {
      joints.add(joint);
      if (!setJoint(skeleton, pose.q, joint, given, scale)) partly.push(given.name);
    }
  }
  for (const { name, weight } of named.morphs) {
    const morph = morphOf(name);
    if (morph === undefined) missing.push(name);
    else pose.morphWeights[morph] = weight;
  }
  return { pose, joints: [...joints].sort((a, b) => a - b), missing, partly };
}

/** Returns whether the joint takes all of the values. */
function setJoint(
  skeleton: Skeleton,
  q: Float64Array,
  joint: number,
  { dofs, values }: NamedJoint,
  scale: number,
): boolean {
  const [from, to] = jointRange(skeleton, joint);
  const letters = dofLetters(skeleton, joint);
  const present = q.slice(from, to);
  const isSame = letters === dofs && values.length === present.length;
  const wanted = isSame ? Float64Array.from(values) : converted(letters, present, dofs, values);
  let at = 0;
  for (const letter of letters) {
    if (isSlide(letter)) wanted[at]! *= scale;
    at += letter === 'Q' ? 4 : 1;
  }
  let isWhole = isSame || keepsAll(letters, wanted, dofs, values, scale);
  wanted.forEach((value, i) => {
    const index = from + i;
    const clamped = Math.min(Math.max(value, skeleton.qMin[index]!), skeleton.qMax[index]!);
    if (clamped !== value) isWhole = false;
    q[index] = clamped;
  });
  return isWhole;
}

/** The values of other degrees of freedom that move a joint as these do, as far as they can. */
function converted(
  letters: string,
  present: Float64Array,
  dofs: string,
  values: readonly number[],
): Float64Array {
  const wanted = present.slice();
  const rotation = rotationOf(dofs, values);
  const hinges = letters.replace(/[xyzsQ]/g, '');
  const given = slidesOf(dofs, values);
  let at = 0;
  let angles: readonly number[] | undefined;
  if (isTriple(hinges)) {
    const first = letters.search(/[XYZ]/);
    angles = tripleAnglesOf(hinges, rotation, present.subarray(first, first + 3));
  }
  for (const letter of letters) {
    if (letter === 'Q') wanted.set(rotation, at);
    else if (isSlide(letter)) wanted[at] = given.get(letter) ?? 0;
    else if (angles) wanted[at] = angles[hinges.indexOf(letter)]!;
    else wanted[at] = values[dofs.indexOf(letter)] ?? 0;
    at += letter === 'Q' ? 4 : 1;
  }
  return wanted;
}

/** Whether the values move a joint just as the given ones do. */
function keepsAll(
  letters: string,
  wanted: Float64Array,
  dofs: string,
  values: readonly number[],
  scale: number,
): boolean {
  const [a, b] = [slidesOf(dofs, values), slidesOf(letters, wanted)];
  const slides = [...a].every(
    ([axis, value]) => Math.abs(value * scale - (b.get(axis) ?? 0)) <= tolerance,
  );
  return slides && isNear(rotationOf(dofs, values), rotationOf(letters, wanted));
}

function isNear(a: Quaternion, b: Quaternion): boolean {
  const dot = Math.abs(a.reduce((sum, value, i) => sum + value * b[i]!, 0));
  return dot > 1 - tolerance;
}

function isSlide(letter: string): boolean {
  return 'xyzs'.includes(letter);
}

/** The values of slides along the coordinate axes, by axis. */
function slidesOf(dofs: string, values: ArrayLike<number>): Map<string, number> {
  const slides = new Map<string, number>();
  let at = 0;
  for (const letter of dofs) {
    if ('xyz'.includes(letter)) slides.set(letter, values[at]!);
    at += letter === 'Q' ? 4 : 1;
  }
  return slides;
}

/**
 * Returns a function that finds the index of a name: of the same name, or else of the only one that
 * differs in letter case alone, or whose other name it is.
 */
function finder(
  names: readonly string[],
  others: readonly string[] = [],
): (name: string) => number | undefined {
  const exact = new Map(names.map((name, index) => [name, index]));
  const loose = new Map<string, number | undefined>();
  for (const list of [names, others]) {
    list.forEach((name, index) => {
      const folded = name.toLowerCase();
      if (folded === '') return;
      const known = loose.has(folded) && loose.get(folded) !== index;
      loose.set(folded, known ? undefined : index);
    });
  }
  return (name) => exact.get(name) ?? loose.get(name.toLowerCase());
}
