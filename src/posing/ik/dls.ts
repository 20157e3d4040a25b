import { natural } from '../natural/natural-solver.ts';
import { Descent } from './descent.ts';
import { IkObjective } from './objective.ts';
import type { IkOptions, IkProblem, IkSolution, IkSolver, IkStep } from './problem.ts';
import { StepBounds } from './step-bounds.ts';
import { singularValues } from './singular-values.ts';
import { startOf, startPose } from './starts.ts';
import { solutionAt, stepAt, worstResidual } from './outcome.ts';
import { isWithinReach, reachedFraction } from './status.ts';
import { sameValues } from './tangent-space.ts';

const defaults = { iterations: 60, restarts: 11, tolerance: 1e-4 } as const;

/** A residual that is not smaller by this part of the chain is no better. */
const notable = 1e-4;

/** Damped least squares in the space of the degrees of freedom. */
export const plainDls: IkSolver = {
  solve(problem, options = {}) {
    const run = new Run(problem, options);
    while (run.advance());
    return run.solution();
  },
  *steps(problem, options = {}) {
    const run = new Run(problem, options);
    yield run.report('The start.');
    for (let isMore = true; isMore;) {
      const values = run.singularValues();
      isMore = run.advance();
      if (run.text !== '') yield run.report(run.text, values);
    }
  },
};

/** Damped least squares in the space of the natures of joints; docs/ik.md describes it. */
export const dls: IkSolver = natural(plainDls);

/** One solve: the first start, and others if it stalls within reach. */
class Run {
  text = '';
  readonly #problem: IkProblem;
  readonly #objective: IkObjective;
  readonly #descent: Descent;
  readonly #from: Float64Array;
  readonly #iterations: number;
  readonly #restarts: number;
  readonly #tolerance: number;
  #best: Float64Array;
  /** The worst residual of the best pose, in lengths of its chain. */
  #bestResidual: number;
  /** The root of its weighted squares, by which poses are compared, and how far from the reference. */
  #bestMiss: number;
  #bestDistance: number;
  /** The number of the present start, -1 for the first. */
  #start = -1;
  #inStart = 0;
  #iterationCount = 0;
  #isDone = false;

  constructor(problem: IkProblem, options: IkOptions) {
    const { skeleton, reference, joints } = problem;
    this.#problem = problem;
    this.#from = startOf(problem, options);
    this.#iterations = options.iterations ?? defaults.iterations;
    this.#restarts = options.restarts ?? defaults.restarts;
    this.#tolerance = options.tolerance ?? defaults.tolerance;
    this.#objective = new IkObjective(problem, this.#from);
    const length = Math.max(...this.#objective.chains.map((chain) => chain.length));
    const { space } = this.#objective;
    const bounds = new StepBounds(space, this.#from, options.mostTurn ?? Infinity, length);
    const isAtReference = sameValues(skeleton, joints, this.#from, reference);
    this.#descent = new Descent(this.#objective, bounds, this.#from, isAtReference ? 0 : 1);
    this.#best = this.#from;
    this.#bestResidual = this.#measure(this.#from);
    this.#bestMiss = this.#miss();
    this.#bestDistance = this.#objective.secondaryCost(this.#from);
    const canMove = this.#objective.space.columnCount > 0 && problem.goals.length > 0;
    this.#isDone = !canMove || (isAtReference && this.#bestResidual <= this.#tolerance);
  }

  /** Does one step; returns whether there is another. */
  advance(): boolean {
    this.text = '';
    if (this.#isDone) return false;
    const descent = this.#descent;
    descent.step();
    this.#inStart++;
    this.#iterationCount++;
    this.text = describe(descent, this.#start);
    if (!descent.isDone && this.#inStart < this.#iterations) return true;
    this.#keepIfBetter();
    this.#isDone = !this.#nextStart();
    return !this.#isDone;
  }

  solution(): IkSolution {
    const { chains, kinematics } = this.#objective;
    return solutionAt(this.#problem, chains, kinematics, this.#best, this.#iterationCount);
  }

  report(text: string, values = this.singularValues()): IkStep {
    return stepAt(this.#problem, this.#objective.kinematics, this.#descent.q, text, values);
  }

  singularValues(): number[] {
    this.#objective.kinematics.update(this.#descent.q);
    return singularValues(this.#objective);
  }

  /** The worst residual in lengths of its chain; leaves the kinematics at q. */
  #measure(q: Float64Array): number {
    const objective = this.#objective;
    objective.kinematics.update(q);
    return worstResidual(objective.chains, objective.kinematics);
  }

  /** Of poses that are equally near to the goals, the one that is nearer to the reference is kept. */
  #keepIfBetter(): void {
    const { q } = this.#descent;
    const residual = this.#measure(q);
    const miss = this.#miss();
    const distance = this.#objective.secondaryCost(q);
    const isAsGood = miss < this.#bestMiss + notable && distance < this.#bestDistance;
    if (!(miss < this.#bestMiss - notable || isAsGood)) return;
    this.#best = q.slice();
    this.#bestResidual = residual;
    this.#bestMiss = miss;
    this.#bestDistance = distance;
  }

  /** How far the goals are missed where the kinematics is, heavy ones counting more. */
  #miss(): number {
    return Math.sqrt(2 * this.#objective.goalCost());
  }

  /** Begins another start if the solve stalled within reach. */
  #nextStart(): boolean {
    const { goals, reference } = this.#problem;
    if (this.#start + 1 >= this.#restarts) return false;
    if (this.#start === -1 && this.#bestResidual <= reachedFraction) return false;
    const isWithin = goals.every((goal, i) => isWithinReach(goal, this.#objective.chains[i]!));
    if (!isWithin) return false;
    this.#start++;
    this.#inStart = 0;
    this.#descent.restart(startPose(this.#objective.space, reference, this.#start));
    return true;
  }
}

function describe({ damping, lastMove }: Descent, start: number): string {
  const where = start === -1 ? '' : ` From start ${start + 2}.`;
  if (lastMove === 0) return `The step made it worse, so that the damping grows.${where}`;
  const degrees = ((lastMove * 180) / Math.PI).toFixed(2);
  return `All moved together, by at most ${degrees}°, with damping ${damping.toExponential(0)}.${where}`;
}
