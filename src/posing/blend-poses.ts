import { jointRange, type Pose } from '../core/pose.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { isTriple, rotationOf, slerp, tripleAnglesOf } from './joint-rotation.ts';
import { dofLetters } from './named-pose.ts';

/**
 * Returns the pose at a fraction of the way between two: at 0 the bits of the first, at 1 those of
 * the second. Slides, single hinges and morphs go straight. Balls, and triples of hinges without
 * limits, turn about one axis at an even pace; a triple with limits goes straight in its angles,
 * since every such angle is within the limits if both ends are.
 */
export function blendPoses(
  skeleton: Skeleton,
  from: Required<Pose>,
  to: Required<Pose>,
  fraction: number,
): Required<Pose> {
  if (fraction <= 0 || fraction >= 1) {
    const { q, morphWeights } = fraction <= 0 ? from : to;
    return { q: q.slice(), morphWeights: morphWeights.slice() };
  }
  const between = (a: Float64Array, b: Float64Array): Float64Array =>
    a.map((value, i) => (value === b[i] ? value : value + fraction * (b[i]! - value)));
  const q = between(from.q, to.q);
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    turnEvenly(skeleton, joint, from.q, to.q, fraction, q);
  }
  return { q, morphWeights: between(from.morphWeights, to.morphWeights) };
}

/** Replaces what goes straight by what turns evenly, where the joint can do that. */
function turnEvenly(
  skeleton: Skeleton,
  joint: number,
  from: Float64Array,
  to: Float64Array,
  fraction: number,
  q: Float64Array,
): void {
  const [start, end] = jointRange(skeleton, joint);
  if (from.subarray(start, end).every((value, i) => value === to[start + i])) return;
  const letters = dofLetters(skeleton, joint);
  const turning = letters.replace(/[xyzs]/g, '');
  const first = start + letters.search(/[XYZQ]/);
  const last = first + (turning === 'Q' ? 4 : 3);
  const isTurned = turning === 'Q' || (isTriple(turning) && isFree(skeleton, first));
  if (!isTurned) return;
  const rotation = slerp(
    rotationOf(turning, from.subarray(first, last)),
    rotationOf(turning, to.subarray(first, last)),
    fraction,
  );
  const straight = q.subarray(first, last);
  q.set(turning === 'Q' ? rotation : tripleAnglesOf(turning, rotation, straight), first);
}

/** Whether three values have no limits. */
function isFree({ qMin, qMax }: Skeleton, first: number): boolean {
  return [first, first + 1, first + 2].every(
    (index) => qMin[index] === -Infinity && qMax[index] === Infinity,
  );
}
