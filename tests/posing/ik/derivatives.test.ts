import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { IkObjective } from '../../../src/posing/ik/objective.ts';
import { SoftRanges } from '../../../src/posing/ik/soft-ranges.ts';
import { difference, integrate, tangentSpace } from '../../../src/posing/ik/tangent-space.ts';
import { largestDifference } from '../../support/compare.ts';
import { randomProblems } from './random-problems.ts';

const step = 1e-5;
/** Central differences with that step are exact to its square, and to rounding over it. */
const differenceError = 1e-8;
const secondDifferenceError = 1e-4;

type Moved = (column: number, amount: number) => Float64Array;

/** The pose q with one column moved. */
function movedFrom(space: IkObjective['space'], q: Float64Array): Moved {
  return (column, amount) => {
    const v = new Float64Array(space.columnCount);
    v[column] = amount;
    const out = q.slice();
    integrate(space, q, v, out);
    return out;
  };
}

describe('the derivatives of inverse kinematics', () => {
  it('are those of the points: slides, hinges and balls have one Jacobian', () => {
    fc.assert(
      fc.property(randomProblems(false), ({ problem, q }) => {
        const objective = new IkObjective(problem, q);
        const { space, kinematics, jacobian, goals } = objective;
        const moved = movedFrom(space, q);
        for (const goal of goals.keys()) {
          kinematics.update(q);
          jacobian.fill(0);
          objective.writeJacobian(goal);
          const exact = jacobian.slice();
          for (let column = 0; column < space.columnCount; column++) {
            const [ahead, behind] = [1, -1].map((sign) => {
              kinematics.update(moved(column, sign * step));
              return [...kinematics.points.subarray(goal * 3, goal * 3 + 3)];
            });
            const rate = ahead!.map((value, axis) => (value - behind![axis]!) / (2 * step));
            const own = [...exact.subarray(column * 3, column * 3 + 3)];
            expect(largestDifference(own, rate)).toBeLessThan(differenceError);
          }
        }
      }),
      { numRuns: 60 },
    );
  });

  it('are those of the objective, the second ones for goals of places too', () => {
    fc.assert(
      fc.property(randomProblems(false), ({ problem, q }) => {
        const goals = problem.goals.map((goal) => ({ ...goal, weight: 1 }));
        const objective = new IkObjective({ ...problem, goals }, q);
        objective.pull = 0.3;
        const { space, gradient } = objective;
        const moved = movedFrom(space, q);
        objective.cost(q);
        objective.linearize(q);
        const exact = gradient.slice();
        const count = space.columnCount;
        const rates = Array.from({ length: count }, (_, column) => {
          const ahead = objective.cost(moved(column, step));
          return (ahead - objective.cost(moved(column, -step))) / (2 * step);
        });
        expect(largestDifference([...exact], rates)).toBeLessThan(100 * differenceError);
      }),
      { numRuns: 60 },
    );
    fc.assert(
      fc.property(randomProblems(false), ({ problem, q }) => {
        const goals = problem.goals.map(({ joint, point, target }) => {
          return { joint, point, target, weight: 1 };
        });
        const objective = new IkObjective({ ...problem, goals }, q);
        objective.pull = 0;
        const { space, squares, curvature } = objective;
        const count = space.columnCount;
        objective.cost(q);
        objective.linearize(q);
        const exact = squares.map((value, at) => value + curvature[at]!);
        const far = 1e-4;
        const cost = (column: number, a: number, row: number, b: number): number => {
          const v = new Float64Array(count);
          v[column] = v[column]! + a;
          v[row] = v[row]! + b;
          const out = q.slice();
          integrate(space, q, v, out);
          return objective.cost(out);
        };
        for (let row = 0; row < count; row++)
          for (let column = 0; column <= row; column++) {
            const sum =
              cost(column, far, row, far) +
              cost(column, -far, row, -far) -
              cost(column, far, row, -far) -
              cost(column, -far, row, far);
            const wanted = sum / (4 * far * far);
            expect(Math.abs(exact[row * count + column]! - wanted)).toBeLessThan(
              secondDifferenceError,
            );
          }
      }),
      { numRuns: 25 },
    );
  });

  it('lead from one pose to another and back', () => {
    fc.assert(
      fc.property(randomProblems(false), ({ problem: { skeleton, joints, reference }, q }) => {
        const space = tangentSpace(skeleton, joints);
        const v = new Float64Array(space.columnCount);
        difference(space, q, reference, v);
        const there = q.slice();
        integrate(space, q, v, there);
        skeleton.dofQ.forEach((at, dof) => {
          const size = skeleton.dofKind[dof] === 2 ? 4 : 1;
          const [a, b] = [there, reference].map((each) => [...each.subarray(at, at + size)]);
          // A quaternion and its opposite are the same rotation.
          const opposite = b!.map((value) => -value);
          const apart = Math.min(
            largestDifference(a!, b!),
            size === 4 ? largestDifference(a!, opposite) : Infinity,
          );
          expect(apart).toBeLessThan(1e-12);
        });
      }),
    );
  });

  it('are those of natural ranges', () => {
    const angle = fc.double({ min: -0.4, max: 0.4, noNaN: true });
    fc.assert(
      fc.property(randomProblems(false), angle, angle, ({ problem, q }, low, high) => {
        const { skeleton, joints, reference } = problem;
        const space = tangentSpace(skeleton, joints);
        const range = [Math.min(low, high), Math.max(low, high)] as const;
        const at = 0.5;
        const natures = joints.map((joint) => ({
          ...{ joint, stiffness: 1, bend: range, side: range, twist: range },
          jointFromNature: [at, -at, at, at] as const,
        }));
        const ranges = new SoftRanges(skeleton, space, natures);
        // Half way to the reference, so that swings stay away from half a turn.
        const v = new Float64Array(space.columnCount);
        difference(space, reference, q, v);
        const pose = reference.slice();
        integrate(
          space,
          skeleton.qRest,
          v.map((value) => 0.2 * value),
          pose,
        );
        const moved = movedFrom(space, pose);
        const gradient = new Float64Array(space.columnCount);
        ranges.accumulate(pose, 1, gradient, new Float64Array(space.columnCount ** 2));
        const rates = Array.from(gradient, (_, column) => {
          const ahead = ranges.cost(moved(column, step));
          return (ahead - ranges.cost(moved(column, -step))) / (2 * step);
        });
        expect(largestDifference([...gradient], rates)).toBeLessThan(1e-3);
      }),
      { numRuns: 60 },
    );
  });
});
