import { sameValue } from '../../core/same-value.ts';
import { goalChains } from './goal-chains.ts';
import type { IkOptions, IkProblem, IkSolution, IkSolver, IkStep } from './problem.ts';

/** The most steps of a method that are kept; what follows them changes little. */
export const mostLabSteps = 200;

/** A step of a method, with its residual as the IK lab shows it. */
export interface LabStep extends IkStep {
  /** The largest residual as a part of its chain's length. */
  readonly error: number;
}

/** What a method did with a problem, step by step. */
export interface LabRun {
  /** The start, and then each step. The last one has the pose of the solution. */
  readonly steps: readonly LabStep[];
  /** How many steps before the last one are left out, because there are too many. */
  readonly leftOut: number;
  readonly solution: IkSolution;
}

/** Runs a method on a problem for its steps and for what it ends with. */
export function runLab(solver: IkSolver, problem: IkProblem, options: IkOptions = {}): LabRun {
  const lengths = goalChains(problem).map(({ length }) => length);
  const steps: LabStep[] = [];
  let leftOut = 0;
  const keep = (step: IkStep): void => {
    const error = step.residuals.reduce((most, each, i) => Math.max(most, each / lengths[i]!), 0);
    // The last place is for the last step, however many come before it.
    if (steps.length > mostLabSteps) {
      steps.pop();
      leftOut++;
    }
    steps.push({ ...step, error });
  };
  for (const step of solver.steps(problem, options)) keep(step);
  const solution = solver.solve(problem, options);
  // After several starts, the last pose that was tried need not be the best one.
  if (!sameValue(steps.at(-1)?.q, solution.q)) {
    keep({
      ...solution,
      text: 'The best of the poses that were found is taken.',
      singularValues: [],
    });
  }
  return { steps, leftOut, solution };
}

/** The number of a kept step among all steps; the start is step 0. */
export function numberOf({ steps, leftOut }: LabRun, index: number): number {
  return index === steps.length - 1 ? index + leftOut : index;
}
