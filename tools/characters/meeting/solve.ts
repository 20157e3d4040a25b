import { axisDofs } from '../../../src/core/pose.ts';
import { DofKind, type Skeleton } from '../../../src/core/skeleton.ts';
import { poseFromJson, type PoseJson } from '../../../src/formats/pose-json.ts';
import { solveLinear } from '../../../src/posing/solve-linear.ts';
import type { Figure, Posed } from './figure.ts';

/** What a pose should reach: numbers that are zero when it does, each weighted by its importance. */
export type Goals = (posed: Posed) => readonly number[];

/** How firmly a joint keeps to the angles at the start: goal units a radian. */
export type Stiffness = (joint: string) => number;

const ITERATIONS = 60;
const STEP = 1e-5;

/** The search ends when a step gains less than this part. */
const SMALL_GAIN = 1e-4;

/**
 * Finds the pose near a first one that meets the goals, by Levenberg and Marquardt's method with
 * differences for derivatives. The joints of the first pose, and its root's displacement, are free.
 */
export function solvePose(
  figure: Figure,
  first: PoseJson,
  goals: Goals,
  stiffness: Stiffness,
): Float64Array {
  const { skeleton } = figure.character;
  const start = poseFromJson('first pose', first, skeleton).value!.q;
  const free = freeValues(skeleton, Object.keys(first.joints ?? {}));
  const firmness = free.map(({ joint }) => stiffness(joint));
  const residuals = (q: Float64Array): number[] => [
    ...goals(figure.posed(q)),
    ...free.map(({ index }, i) => firmness[i]! * (q[index]! - start[index]!)),
  ];
  let q = start.slice();
  let current = residuals(q);
  let damping = 1e-3;
  for (let iteration = 0; iteration < ITERATIONS; iteration++) {
    const columns = free.map(({ index }) => {
      const moved = q.slice();
      moved[index]! += STEP;
      return residuals(moved).map((value, i) => (value - current[i]!) / STEP);
    });
    const normal = columns.map((a) => columns.map((b) => product(a, b)));
    const right = columns.map((column) => -product(column, current));
    const before = product(current, current);
    for (let attempt = 0; attempt < 8; attempt++) {
      const damped = normal.map((row, i) => row.map((v, j) => (i === j ? v * (1 + damping) : v)));
      const step = solveLinear(damped, right)!;
      const next = q.slice();
      for (const [i, { index }] of free.entries()) next[index]! += step[i]!;
      const found = residuals(next);
      if (product(found, found) < before) {
        [q, current] = [next, found];
        damping /= 3;
        break;
      }
      damping *= 4;
    }
    if (product(current, current) > before * (1 - SMALL_GAIN)) break;
  }
  return q;
}

/** The hinges of these joints, and the slides of the root. */
function freeValues(skeleton: Skeleton, joints: readonly string[]) {
  const valuesOf = (joint: string, wanted: DofKind) =>
    axisDofs(skeleton, skeleton.names.indexOf(joint))
      .filter(({ kind }) => kind === wanted)
      .map(({ index }) => ({ joint, index }));
  return [
    ...valuesOf('Root', DofKind.slide),
    ...joints.flatMap((joint) => valuesOf(joint, DofKind.hinge)),
  ];
}

function product(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, value, i) => sum + value * b[i]!, 0);
}
