import { dls } from '../../src/posing/ik/dls.ts';
import type { IkProblem, Vector3 } from '../../src/posing/ik/problem.ts';
import { goalAt, placeOf, skeletonOf, triple } from '../../tests/posing/ik/ik-rigs.ts';
import { type BenchOptions, expectRight, type GroupResult } from '../harness/group.ts';
import { contenderOf, measure } from '../harness/measure.ts';
import { spreadOf } from '../harness/statistics.ts';

/** The frames of one round of the targets, two seconds at 60 a second. */
const frameCount = 120;
/** What a drag passes for a frame. */
const options = { restarts: 0, iterations: 10, mostTurn: (4 * Math.PI) / 180 };

/** A frame of a drag of both hands: two goals, ten joints of three hinges. */
export async function inverseKinematics({ rounds }: BenchOptions): Promise<GroupResult> {
  const dragged = dragOfTwoHands();
  for (let frame = 0; frame < 2 * frameCount; frame++) {
    const { residuals } = dragged.run(frame);
    expectRight(Math.max(...residuals) < 0.02, 'the hands do not follow their targets');
  }
  const samples = await measure([contenderOf('dls', dragged.run)], rounds);
  const taken = samples['dls']!;
  const { lower, median, upper } = spreadOf(taken.map(({ wall }) => wall));
  return {
    samples,
    values: { 'ik-frame': { value: median, lower, upper } },
    counts: { 'degrees of freedom': dragged.valueCount, goals: 2 },
  };
}

function dragOfTwoHands() {
  const skeleton = skeletonOf([
    [-1, [0, 1, 0], triple()],
    [0, [0, 0.15, 0], triple()],
    [1, [0, 0.15, 0], triple()],
    [2, [0, 0.15, 0], triple()],
    [3, [0.05, 0.1, 0], triple()],
    [4, [0.15, 0, 0], triple()],
    [5, [0.2, -0.2, 0.05], triple()],
    [3, [-0.05, 0.1, 0], triple()],
    [7, [-0.15, 0, 0], triple()],
    [8, [-0.2, -0.2, 0.05], triple()],
  ]);
  const reference = skeleton.qRest;
  const hand: Vector3 = [0, -0.15, 0.2];
  const goals = [goalAt(6, hand), goalAt(9, hand)];
  const starts = goals.map(({ joint, point }) => placeOf(skeleton, reference, joint, point));
  const joints = Array.from(skeleton.names.keys());
  let from = reference;
  return { valueCount: reference.length, run };

  function run(frame: number) {
    const angle = (2 * Math.PI * frame) / frameCount;
    const [across, up] = [0.15 * Math.sin(angle), 0.15 * (1 - Math.cos(angle))];
    const moved = goals.map((goal, side) => {
      const [x, y, z] = starts[side]!;
      return { ...goal, target: [x + across, y + up, z + 0.5 * across] as const };
    });
    const problem: IkProblem = { skeleton, goals: moved, joints, reference, natures: [] };
    const solution = dls.solve(problem, { ...options, from });
    from = solution.q;
    return solution;
  }
}
