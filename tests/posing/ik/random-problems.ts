import fc from 'fast-check';
import { buildSkeleton } from '../../../src/core/build-skeleton.ts';
import type { DofParts, JointParts } from '../../../src/core/character-parts.ts';
import { DiagnosticLog } from '../../../src/core/diagnostics.ts';
import { DofKind, type Skeleton } from '../../../src/core/skeleton.ts';
import type { IkProblem, Quaternion } from '../../../src/posing/ik/problem.ts';
import {
  randomBetween,
  randomRotation,
  randomSource,
  randomUnitVector,
} from '../../support/random.ts';

/** A problem for a random forest of slides, hinges and balls, and a pose of it. */
export interface RandomProblem {
  readonly problem: IkProblem;
  readonly q: Float64Array;
}

/** @param limited whether hinges and slides have limits, around the poses that come with them */
export function randomProblems(limited: boolean): fc.Arbitrary<RandomProblem> {
  return fc.integer({ min: 1, max: 1e9 }).map((seed) => randomProblem(randomSource(seed), limited));
}

function randomProblem(random: () => number, limited: boolean): RandomProblem {
  const number = (low: number, high: number): number => randomBetween(random, low, high);
  const vector = (): [number, number, number] => [number(-1, 1), number(-1, 1), number(-1, 1)];
  const count = Math.floor(number(2, 7));
  const joints = Array.from({ length: count }, (_, index): JointParts => ({
    name: `#${index}`,
    // Mostly chains, sometimes branches.
    parent: random() < 0.8 ? index - 1 : Math.floor(number(-1, index)),
    restOffset: vector(),
    restRotation: randomRotation(random, 2) as unknown as Quaternion,
    dofs: Array.from({ length: Math.floor(number(0, 4)) }, () => randomDof()),
  }));
  const skeleton = buildSkeleton({ file: 'random', joints }, new DiagnosticLog('random'))!;
  const q = randomPose(skeleton, random);
  const goals = Array.from({ length: Math.floor(number(1, 4)) }, (_, index) => ({
    joint: Math.floor(number(0, count)),
    point: vector(),
    target: vector(),
    weight: number(0.5, 3),
    ...(index === 1 && { rotation: randomRotation(random, 1) as unknown as Quaternion }),
  }));
  const reference = randomPose(skeleton, random);
  const all = Array.from(skeleton.names.keys());
  return { problem: { skeleton, goals, joints: all, reference, natures: [] }, q };

  function randomDof(): DofParts {
    const kinds = [DofKind.slide, DofKind.hinge, DofKind.hinge, DofKind.ball];
    const kind = kinds[Math.floor(number(0, kinds.length))]!;
    const axis = randomUnitVector(random) as [number, number, number];
    if (kind === DofKind.ball) return { kind, axis: [0, 0, 0], rest: randomRotation(random, 2) };
    return { kind, axis, ...(limited && { limits: [-number(0, 1), number(0, 1)] }) };
  }
}

/** A pose within the limits; hinges and slides are within ±1. */
function randomPose(skeleton: Skeleton, random: () => number): Float64Array {
  const q = skeleton.qRest.slice();
  skeleton.dofKind.forEach((kind, dof) => {
    const at = skeleton.dofQ[dof]!;
    const [min, max] = [Math.max(skeleton.qMin[at]!, -1), Math.min(skeleton.qMax[at]!, 1)];
    if ((kind as DofKind) === DofKind.ball) q.set(randomRotation(random, 2.5), at);
    else q[at] = randomBetween(random, min, max);
  });
  return q;
}
