import { vec3 } from 'gl-matrix';
import { blendPoses } from '../blend-poses.ts';
import { pullNaturally } from '../natural/natural-solver.ts';
import { type ChainParts, type ChainProblem, chainProblem } from './chain-problem.ts';
import type { IkOptions, IkSolution, IkSolver, Vector3 } from './problem.ts';
import { SmoothTarget } from './smooth-target.ts';

/** How long easing to another pose takes, in seconds. */
const easeTime = 0.12;
/** The most iterations of a frame, and the most frames' worth of them at the end of a drag. */
const [frameIterations, lastFrames] = [10, 5];
/** The time constant of the pull to the pose of the start, in seconds. */
const pullTime = 0.15;
/** A hand that passes this part of the reach in a second is followed first; the rest waits. */
const fastPart = 0.5;
/**
 * As parts of the reach: where a point is at its target, where it is apart from it, and where it is
 * so far that other starts are tried.
 */
const [tolerance, apartPart, stuckPart] = [1e-4, 5e-3, 0.02];
/** The most iterations once the hand rests, in which its pose is solved to the end. */
const [restingIterations, mostImprovements] = [100, 5];
/** How many other starts are tried, with how many iterations each. */
const [restarts, restartIterations] = [10, 60];
/** They are tried again when the target has moved by this part of the reach. */
const retryPart = 0.05;
/** How far a joint turns in a second at most while the hand moves, in radians: 4° in a frame. */
const turnRate = (240 * Math.PI) / 180;
/** A drag rests when nothing moves by more than these in a frame: parts of the reach, and q. */
const [stillPart, stillValue] = [1e-4, 1e-5];
/** In seconds after the last move of the hand; then it rests in any case. */
const longestSettling = 1.5;

/** What a drag of a chain starts from. */
export interface ChainDragStart extends ChainParts {
  readonly solver: IkSolver;
  /** The time of the start, by any clock. */
  readonly seconds: number;
}

/** A drag at a moment. */
export interface ChainMoment {
  /** (qCount) the pose to show, which the caller may keep. */
  readonly q: Float64Array;
  /** Where the hand wants the point, in the character's space. */
  readonly target: Vector3;
  /** How far the point is from its target. */
  readonly residual: number;
  /** Whether that is so far that it should be said. */
  readonly isApart: boolean;
  /** Whether later moments are the same, as long as the hand rests. */
  readonly isAtRest: boolean;
}

/**
 * A drag that moves a point of a chain to where the hand is. Its moments depend only on the start
 * and on where the hand was when.
 *
 * The target follows the hand through a low-pass, and each moment is solved from the one before.
 * While the hand is slow, the chain is first pulled a little to the pose of the start: to first
 * order that moves it in the null space of the goals, by any method, so that a hand that returns
 * brings the pose back. If a slow hand's point is stuck apart from a target within reach, other
 * starts are tried, and a better pose is eased into.
 */
export class ChainDrag {
  private readonly start: ChainDragStart;
  private readonly problem: ChainProblem;
  private readonly target: SmoothTarget;
  private seconds: number;
  private movedAt: number;
  /** Where the target is at this moment. */
  private smooth: Vector3;
  /** The solved pose, which is shown unless it is eased into. */
  private solved: Float64Array;
  private residual = 0;
  private shown: Float64Array;
  private easing: { readonly from: Float64Array; readonly since: number } | null = null;
  /** How many times the pose was solved to the end since the hand moved. */
  private improvements = 0;
  /** The target for which other starts were tried last. */
  private triedAt: Vector3 | null = null;

  /** @param present the pose that is shown, from which the drag eases if it is not the start's */
  constructor(start: ChainDragStart, present = start.q) {
    this.start = start;
    this.problem = chainProblem(start);
    this.smooth = this.problem.placeIn(present);
    this.target = new SmoothTarget(this.smooth, start.seconds);
    this.seconds = start.seconds;
    this.movedAt = start.seconds;
    this.shown = present;
    this.solved = start.q;
    if (present !== start.q) this.easing = { from: present, since: start.seconds };
  }

  /** The joints of the chain, from the one that begins it to the one that is dragged. */
  get joints(): readonly number[] {
    return this.problem.chain;
  }

  /** Where the dragged point is now, in the character's space. */
  get place(): Vector3 {
    return this.problem.placeIn(this.shown);
  }

  /** Tells where the hand is, in the character's space. */
  aim(place: Vector3, seconds: number): void {
    if (place.every((value, i) => value === this.target.aim[i])) return;
    this.target.tell(place, seconds);
    this.improvements = 0;
    this.movedAt = seconds;
  }

  /** Advances to a moment, which is not before the last one. */
  advance(seconds: number): ChainMoment {
    const time = Math.max(0, seconds - this.seconds);
    const [before, former] = [this.shown, this.smooth];
    this.seconds += time;
    this.smooth = this.target.at(this.seconds);
    const speed = time > 0 ? distance(former, this.smooth) / time : Infinity;
    const calm = Math.max(0, 1 - speed / (fastPart * this.problem.reach));
    const mostTurn = turnRate * time;
    const hasArrived = distance(this.smooth, this.target.aim) <= stillPart * this.problem.reach;
    const reference = hasArrived ? this.start.q : this.pulled(calm * time);
    this.take(this.solve(reference, { iterations: frameIterations, mostTurn }));
    if (calm > 0) this.tryOthers();
    this.show();
    const isStill =
      hasArrived && this.shown.every((value, i) => Math.abs(value - before[i]!) <= stillValue);
    const isLong = this.seconds - this.movedAt > longestSettling;
    const mayRest = time > 0 && this.easing === null && (isStill || isLong);
    if (mayRest) this.improve();
    return this.moment(mayRest && this.easing === null);
  }

  /** Ends at once where the hand is. */
  finish(): ChainMoment {
    this.smooth = this.target.arrive();
    for (let i = 0; i < lastFrames; i++) {
      const former = this.residual;
      this.take(this.solve(this.solved, { iterations: frameIterations }));
      if (this.residual <= tolerance * this.problem.reach || this.residual === former) break;
    }
    this.tryOthers();
    this.easing = null;
    this.show();
    return this.moment(true);
  }

  /** A point that is apart from its target needs all of the chain's freedom to come nearer. */
  private pulled(time: number): Float64Array {
    if (time === 0 || this.residual > apartPart * this.problem.reach) return this.solved;
    const problem = this.problem.toward(this.smooth, this.solved);
    return pullNaturally(problem, this.solved, this.start.q, 1 - Math.exp(-time / pullTime));
  }

  /**
   * Once the hand rests, the pose is solved to the end and eased into, so that it depends on where
   * the hand is and not on how many frames led there.
   */
  private improve(): void {
    if (this.improvements === mostImprovements) return;
    const found = this.solve(this.start.q, { iterations: restingIterations });
    const isSame = found.q.every((value, i) => Math.abs(value - this.solved[i]!) <= stillValue);
    this.improvements = isSame ? mostImprovements : this.improvements + 1;
    if (isSame) return;
    this.easing = { from: this.shown, since: this.seconds };
    this.take(found);
  }

  private tryOthers(): void {
    const { reach, begin } = this.problem;
    const isStuck = this.residual > stuckPart * reach && distance(this.smooth, begin) < reach;
    const isTried = this.triedAt && distance(this.triedAt, this.smooth) < retryPart * reach;
    if (!isStuck || isTried) return;
    this.triedAt = this.smooth;
    const found = this.solve(this.start.q, { iterations: restartIterations, restarts });
    if (found.residuals[0]! > this.residual - apartPart * reach) return;
    this.easing = { from: this.shown, since: this.seconds };
    this.take(found);
  }

  /** Solves from the present pose, and stays as near to the reference as the goals allow. */
  private solve(reference: Float64Array, options: IkOptions): IkSolution {
    const problem = this.problem.toward(this.smooth, reference);
    const from = this.solved;
    return this.start.solver.solve(problem, { from, restarts: 0, tolerance, ...options });
  }

  private take({ q, residuals }: IkSolution): void {
    this.solved = q;
    this.residual = residuals[0]!;
  }

  private show(): void {
    if (this.easing) {
      const part = (this.seconds - this.easing.since) / easeTime;
      if (part >= 1) this.easing = null;
      else {
        this.shown = this.mix(this.easing.from, this.solved, part * part * (3 - 2 * part));
        return;
      }
    }
    this.shown = this.solved;
  }

  private mix(from: Float64Array, to: Float64Array, part: number): Float64Array {
    const morphWeights = new Float64Array(0);
    const [a, b] = [from, to].map((q) => ({ q, morphWeights }));
    return blendPoses(this.start.skeleton, a!, b!, part).q;
  }

  private moment(isAtRest: boolean): ChainMoment {
    const { residual } = this;
    const isApart = residual > apartPart * this.problem.reach;
    return { q: this.shown.slice(), target: this.target.aim, residual, isApart, isAtRest };
  }
}

function distance(a: Vector3, b: Vector3): number {
  return vec3.distance([...a], [...b]);
}
