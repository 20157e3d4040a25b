import { DofKind } from '../../core/skeleton.ts';
import { negativeDirection, solveDefinite } from './cholesky.ts';
import type { IkObjective } from './objective.ts';
import type { StepBounds } from './step-bounds.ts';
import { integrate } from './tangent-space.ts';

/** The farthest that one step turns a degree of freedom, in radians. */
const stepCap = 0.5;
/** The pull in each stage: first the large moves are made, then the goals are met exactly. */
const pulls = [1e-2, 1e-4, 1e-6] as const;
/** A stage ends when a step is shorter than this, in radians. */
const smallSteps = [1e-3, 1e-3, 1e-5] as const;
/** How far the joint that turns most is turned away from a saddle, in radians. */
const nudge = 0.05;
/** In one stage; a limb of several joints can need more than one. */
const mostNudges = 4;

/**
 * Damped least squares from one start, step by step (Wampler 1986; Levenberg–Marquardt control after
 * Nielsen 1999). Each step solves `(H + λ S²) v = −g` for the columns that no limit stops, where H is
 * the matrix of the objective, S the stiffness and g the gradient.
 */
export class Descent {
  /** (qCount) the pose that has been reached. */
  readonly q: Float64Array;
  /** The damping λ of the last step. */
  damping = 0;
  /** How far the last step turned the joint that it turned most, in radians. */
  lastMove = 0;
  isDone = false;
  readonly #objective: IkObjective;
  readonly #bounds: StepBounds;
  readonly #trial: Float64Array;
  readonly #step: Float64Array;
  readonly #right: Float64Array;
  readonly #diagonal: Float64Array;
  readonly #matrix: Float64Array;
  readonly #factor: Float64Array;
  readonly #free: Uint16Array;
  readonly #isFixed: Uint8Array;
  readonly #order: Uint16Array;
  #stage = 0;
  #nudgesLeft = 0;
  #cost = 0;
  #nextDamping = 0;
  #isLinear = false;
  #hasCurvature = true;

  /**
   * @param stage the first stage: 1 leaves out the large moves, for a start near the solution
   */
  constructor(objective: IkObjective, bounds: StepBounds, from: Float64Array, stage: 0 | 1) {
    const { columnCount } = objective.space;
    this.#bounds = bounds;
    this.#objective = objective;
    this.q = from.slice();
    this.#trial = from.slice();
    this.#step = new Float64Array(columnCount);
    this.#right = new Float64Array(columnCount);
    this.#diagonal = new Float64Array(columnCount);
    this.#matrix = new Float64Array(columnCount * columnCount);
    this.#factor = new Float64Array(columnCount * columnCount);
    this.#free = new Uint16Array(columnCount);
    this.#isFixed = new Uint8Array(columnCount);
    this.#order = new Uint16Array(columnCount);
    this.#enterStage(stage);
  }

  /**
   * Continues from another pose. The first stage is left out, because it would pull the pose back to
   * where the last start ended.
   */
  restart(from: Float64Array): void {
    this.q.set(from);
    this.#trial.set(from);
    this.isDone = false;
    this.#enterStage(1);
  }

  /** Does one step: solves, and moves if the objective falls. */
  step(): void {
    const objective = this.#objective;
    if (!this.#isLinear) {
      objective.linearize(this.q);
      this.#isLinear = true;
      this.#hasCurvature = true;
    }
    this.damping = this.#nextDamping;
    const predicted = this.#solve();
    const move = this.#lengthOfStep();
    this.lastMove = 0;
    if (move > 0 && predicted > 0) {
      const cost = this.#costAhead();
      if (cost < this.#cost) {
        const gain = (this.#cost - cost) / predicted;
        this.q.set(this.#trial);
        this.#cost = cost;
        this.#isLinear = false;
        this.lastMove = move;
        this.#nextDamping = this.damping * (gain > 0.75 ? 0.1 : gain > 0.25 ? 0.5 : 4);
        if (move < smallSteps[this.#stage]!) this.#endStage();
        return;
      }
      objective.kinematics.update(this.q);
    }
    this.#nextDamping = this.damping * 10;
    if (move < 0.1 * smallSteps[this.#stage]! || this.#nextDamping > 1e6) this.#endStage();
  }

  #endStage(): void {
    if (this.#nudgesLeft > 0 && this.#leaveSaddle()) this.#nudgesLeft--;
    else this.#enterStage(this.#stage + 1);
  }

  /**
   * A limb that is straight along the line to its target, such as a leg whose knee starts at its
   * limit, has no gradient although bending it would help. Where the second derivatives are negative
   * along a direction, the pose is moved a little along it, to the better side. Returns whether it was.
   */
  #leaveSaddle(): boolean {
    const objective = this.#objective;
    objective.linearize(this.q);
    const { squares, curvature } = objective;
    const [matrix, step] = [this.#matrix, this.#step];
    for (let i = 0; i < matrix.length; i++) matrix[i] = squares[i]! + curvature[i]!;
    this.#orderByLimits();
    if (!negativeDirection(matrix, this.#order, this.#factor, step)) return false;
    const move = this.#lengthOfStep();
    for (let i = 0; i < step.length; i++) step[i] = (step[i]! * nudge) / move;
    const ahead = this.#costAhead();
    for (let i = 0; i < step.length; i++) step[i] = -step[i]!;
    const behind = this.#costAhead();
    if (Math.min(ahead, behind) >= this.#cost) {
      objective.kinematics.update(this.q);
      return false;
    }
    if (ahead < behind) for (let i = 0; i < step.length; i++) step[i] = -step[i]!;
    this.#cost = this.#costAhead();
    this.q.set(this.#trial);
    this.#nextDamping = 0.1 * pulls[this.#stage]!;
    this.#isLinear = false;
    return true;
  }

  /** Orders the columns: those that are free, and then those at a limit. */
  #orderByLimits(): void {
    const { coordinates, low, high } = this.#bounds;
    this.#bounds.measure(this.q);
    let count = 0;
    for (const wantsLimit of [false, true])
      for (let i = 0; i < coordinates.length; i++) {
        const isAtLimit = coordinates[i]! <= low[i]! || coordinates[i]! >= high[i]!;
        if (isAtLimit === wantsLimit) this.#order[count++] = i;
      }
  }

  /** The objective where the step leads; `#trial` is that pose. */
  #costAhead(): number {
    integrate(this.#objective.space, this.q, this.#step, this.#trial);
    this.#bounds.clamp(this.#trial);
    return this.#objective.cost(this.#trial);
  }

  #enterStage(stage: number): void {
    if (stage === pulls.length) {
      this.isDone = true;
      return;
    }
    this.#stage = stage;
    this.#nudgesLeft = mostNudges;
    this.#objective.pull = pulls[stage]!;
    this.#nextDamping = 0.1 * pulls[stage]!;
    this.#cost = this.#objective.cost(this.q);
    this.#isLinear = false;
  }

  /**
   * Solves for the step, within the limits: columns at a limit whose gradient points outwards are
   * left out, and those that would pass a limit go exactly there while the others are solved again.
   * Returns how much the objective should fall.
   */
  #solve(): number {
    const { gradient, resistance } = this.#objective;
    const { coordinates, low, high } = this.#bounds;
    const columnCount = gradient.length;
    const [step, isFixed] = [this.#step, this.#isFixed];
    this.#bounds.measure(this.q);
    for (let i = 0; i < columnCount; i++) {
      const atMin = coordinates[i]! <= low[i]! && gradient[i]! >= 0;
      const atMax = coordinates[i]! >= high[i]! && gradient[i]! <= 0;
      isFixed[i] = atMin || atMax ? 1 : 0;
      step[i] = 0;
    }
    for (let i = 0; i < columnCount; i++) this.#diagonal[i] = this.damping * resistance[i]!;
    for (let sweep = 0; sweep < 4; sweep++) {
      this.#solveFree();
      if (!this.#fixAtLimits()) break;
    }
    this.#capStep();
    return this.#predictedFall();
  }

  #solveFree(): void {
    const { space, gradient, squares, curvature } = this.#objective;
    const { columnCount } = space;
    const [step, right, isFixed] = [this.#step, this.#right, this.#isFixed];
    for (;;) {
      const matrix = this.#matrix;
      if (this.#hasCurvature)
        for (let i = 0; i < matrix.length; i++) matrix[i] = squares[i]! + curvature[i]!;
      else matrix.set(squares);
      let count = 0;
      for (let i = 0; i < columnCount; i++) {
        if (isFixed[i] === 0) this.#free[count++] = i;
        let sum = -gradient[i]!;
        for (let k = 0; k < columnCount; k++) {
          if (isFixed[k] === 0 || step[k] === 0) continue;
          sum -= matrix[i > k ? i * columnCount + k : k * columnCount + i]! * step[k]!;
        }
        right[i] = sum;
      }
      const free = this.#free;
      if (solveDefinite(matrix, this.#diagonal, right, free, count, this.#factor, step)) return;
      // Within reach the second derivatives can make a saddle; the squares alone never do.
      if (this.#hasCurvature) this.#hasCurvature = false;
      else for (let i = 0; i < columnCount; i++) this.#diagonal[i] = 10 * this.#diagonal[i]!;
    }
  }

  /** Sends the columns whose step would pass a limit to that limit. Returns whether there are any. */
  #fixAtLimits(): boolean {
    const { coordinates, low, high } = this.#bounds;
    const [step, isFixed] = [this.#step, this.#isFixed];
    let found = false;
    for (let i = 0; i < coordinates.length; i++) {
      if (isFixed[i] === 1) continue;
      const wanted = coordinates[i]! + step[i]!;
      if (wanted >= low[i]! && wanted <= high[i]!) continue;
      step[i] = Math.min(Math.max(wanted, low[i]!), high[i]!) - coordinates[i]!;
      isFixed[i] = 1;
      found = true;
    }
    return found;
  }

  #capStep(): void {
    const move = this.#lengthOfStep();
    if (move <= stepCap) return;
    for (let i = 0; i < this.#step.length; i++) this.#step[i] = this.#step[i]! * (stepCap / move);
  }

  /** The largest turn of a column, in radians, or slide in units of turns. */
  #lengthOfStep(): number {
    const { resistance, space } = this.#objective;
    let most = 0;
    for (let i = 0; i < this.#step.length; i++) {
      const unit = space.kinds[i] === DofKind.slide ? Math.sqrt(resistance[i]!) : 1;
      most = Math.max(most, unit * Math.abs(this.#step[i]!));
    }
    return most;
  }

  #predictedFall(): number {
    const { gradient, squares, curvature, space } = this.#objective;
    const { columnCount } = space;
    const step = this.#step;
    let fall = 0;
    for (let i = 0; i < columnCount; i++) {
      fall -= gradient[i]! * step[i]!;
      for (let k = 0; k <= i; k++) {
        const at = i * columnCount + k;
        const element = this.#hasCurvature ? squares[at]! + curvature[at]! : squares[at]!;
        fall -= (i === k ? 0.5 : 1) * element * step[i]! * step[k]!;
      }
    }
    return fall;
  }
}
