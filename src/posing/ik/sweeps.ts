import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { natural } from '../natural/natural-solver.ts';
import { type GoalChain, goalChains } from './goal-chains.ts';
import { GoalKinematics } from './goal-kinematics.ts';
import { solutionAt, stepAt, weightedMiss, worstResidual } from './outcome.ts';
import type { IkOptions, IkProblem, IkSolver } from './problem.ts';
import { startOf } from './starts.ts';
import { integrate, sameValues, type TangentSpace, tangentSpace } from './tangent-space.ts';

const defaults = { iterations: 100, tolerance: 1e-4 } as const;
/** A sweep that gains less than this, in lengths of the chain, gains nothing. */
const leastGain = 1e-7;
/** So many sweeps in a row that gain nothing end the solve: projections to limits also cost some. */
const mostIdle = 5;

/** The state of a method that turns one column after the other. */
export class Sweeper {
  readonly problem: IkProblem;
  readonly space: TangentSpace;
  readonly chains: readonly GoalChain[];
  readonly kinematics: GoalKinematics;
  /** (qCount) the present pose. */
  readonly q: Float64Array;
  readonly #move: Float64Array;

  constructor(problem: IkProblem, options: IkOptions) {
    this.problem = problem;
    this.q = startOf(problem, options);
    this.space = tangentSpace(problem.skeleton, problem.joints);
    this.chains = goalChains(problem);
    this.kinematics = new GoalKinematics(problem.skeleton, problem.goals, this.space, this.q);
    this.kinematics.update(this.q);
    this.#move = new Float64Array(this.space.columnCount);
  }

  /**
   * Moves one column within its limits, and the kinematics with it. Returns how far it went, in
   * radians or model units.
   */
  move(column: number, amount: number): number {
    const { kinds, values, min, max } = this.space;
    const value = this.q[values[column]!]!;
    const isBall = kinds[column] === DofKind.ball;
    const moved = isBall
      ? amount
      : Math.min(Math.max(value + amount, min[column]!), max[column]!) - value;
    if (moved === 0) return 0;
    this.#move[column] = moved;
    integrate(this.space, this.q, this.#move, this.q);
    this.#move[column] = 0;
    this.kinematics.update(this.q);
    return moved;
  }

  /** Says what a move did: "Left elbow turned by 12.0° about X, to its limit." */
  describe(column: number, moved: number): string {
    const { skeleton } = this.problem;
    const { kinds, values, joints, min, max } = this.space;
    const isSlide = kinds[column] === DofKind.slide;
    const amount = isSlide ? moved.toPrecision(3) : `${((moved * 180) / Math.PI).toFixed(1)}°`;
    const value = this.q[values[column]!]!;
    const isBall = kinds[column] === DofKind.ball;
    const isAtLimit = !isBall && (value === min[column]! || value === max[column]!);
    const [verb, way] = isSlide ? ['slid', 'along'] : ['turned', 'about'];
    const name = skeleton.names[joints[column]!]!;
    const where = `${way} ${this.#axisName(skeleton, column)}`;
    return `${name} ${verb} by ${amount} ${where}${isAtLimit ? ', to its limit' : ''}.`;
  }

  #axisName({ dofAxis }: Skeleton, column: number): string {
    const { kinds, dofs, axes } = this.space;
    const own = dofs[column]! * 3;
    const axis =
      kinds[column] === DofKind.ball
        ? axes[column]!
        : [0, 1, 2].findIndex((each) => dofAxis[own + each] === 1);
    return ['X', 'Y', 'Z'][axis] ?? 'its axis';
  }
}

/** A column that a sweep moved, and by how much. */
export interface Move {
  readonly column: number;
  readonly moved: number;
}

/**
 * A solver that sweeps over the columns until the goals are reached or sweeps gain nothing, and keeps
 * to the natures of joints.
 */
export function naturalSweeps(sweep: (sweeper: Sweeper) => Generator<Move>): IkSolver {
  return natural(sweepingSolver(sweep));
}

function sweepingSolver(sweep: (sweeper: Sweeper) => Generator<Move>): IkSolver {
  return {
    solve(problem, options = {}) {
      const sweeper = new Sweeper(problem, options);
      let iterations = 0;
      for (const move of run(sweeper, options)) if (move === null) iterations++;
      return solutionAt(problem, sweeper.chains, sweeper.kinematics, sweeper.q, iterations);
    },
    *steps(problem, options = {}) {
      const sweeper = new Sweeper(problem, options);
      yield stepAt(problem, sweeper.kinematics, sweeper.q, 'The start.');
      for (const move of run(sweeper, options)) {
        if (move === null) continue;
        const text = sweeper.describe(move.column, move.moved);
        yield stepAt(problem, sweeper.kinematics, sweeper.q, text);
      }
    },
  };

  /** Yields each move, and null after each sweep. */
  function* run(sweeper: Sweeper, options: IkOptions): Generator<Move | null> {
    const { problem, chains, kinematics, q } = sweeper;
    const tolerance = options.tolerance ?? defaults.tolerance;
    const most = options.iterations ?? defaults.iterations;
    const best = q.slice();
    let least = weightedMiss(chains, kinematics);
    let idle = 0;
    const isReached = (): boolean => worstResidual(chains, kinematics) <= tolerance;
    for (let count = 0; count < most && idle < mostIdle && !isReached(); count++) {
      yield* sweep(sweeper);
      yield null;
      kinematics.update(q);
      const miss = weightedMiss(chains, kinematics);
      idle = miss < least - leastGain ? 0 : idle + 1;
      if (miss >= least) continue;
      best.set(q);
      least = miss;
    }
    if (!sameValues(problem.skeleton, problem.joints, best, q)) q.set(best);
  }
}
