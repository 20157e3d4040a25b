import { DofKind } from '../../core/skeleton.ts';
import { type GoalChain, goalChains } from './goal-chains.ts';
import { GoalKinematics } from './goal-kinematics.ts';
import type { IkGoal, IkProblem } from './problem.ts';
import { turnBetween } from './quaternions.ts';
import { SoftRanges } from './soft-ranges.ts';
import type { SoftTask } from './soft-task.ts';
import { difference, type TangentSpace, tangentSpace } from './tangent-space.ts';

/** How many lengths of its chain a goal's orientation counts for, per radian. */
const lengthPerRadian = 0.3;
/**
 * Beyond this part of its chain, the residual of a goal pulls no harder if a heavier goal exists, so
 * that a target far away does not pull a pinned foot off its place.
 */
const residualCap = 0.3;

/**
 * What damped least squares minimizes over the values of the joints:
 *
 * `½ Σ weight² |residual / chain length|² + ½ pull · (100 Σ soft rows² + Σ (stiffness · offset)²)`
 *
 * where the offset is the tangent vector from the reference. With a small pull this is the pull in
 * the null space of the goals, but one function, whose minimum moves smoothly with the targets.
 */
export class IkObjective {
  readonly space: TangentSpace;
  readonly chains: readonly GoalChain[];
  readonly goals: readonly IkGoal[];
  readonly kinematics: GoalKinematics;
  /** How much the reference pulls; a smaller pull gives smaller residuals. */
  pull = 1;
  /** (columnCount) how much each column resists, squared. */
  readonly resistance: Float64Array;
  /** (columnCount) of the objective, after `linearize`. */
  readonly gradient: Float64Array;
  /** (columnCount²) Jᵀ J of all rows after `linearize`; the lower triangle. */
  readonly squares: Float64Array;
  /**
   * (columnCount²) what the goals' second derivatives add to `squares`; the lower triangle. Outside
   * the reach it damps, the more the larger the residual is.
   */
  readonly curvature: Float64Array;
  /** (columnCount × 3) how the columns move the point of one goal: scratch of `linearize`. */
  readonly jacobian: Float64Array;
  readonly #reference: Float64Array;
  readonly #tasks: readonly SoftTask[];
  readonly #offset: Float64Array;
  readonly #turn = new Float64Array(3);
  readonly #caps: readonly number[];

  constructor({ skeleton, goals, joints, reference, natures }: IkProblem, from: Float64Array) {
    const problem = { skeleton, goals, joints, reference, natures };
    this.goals = goals;
    this.chains = goalChains(problem);
    this.space = tangentSpace(skeleton, joints);
    this.kinematics = new GoalKinematics(skeleton, goals, this.space, from);
    this.#reference = reference;
    this.#tasks = [new SoftRanges(skeleton, this.space, natures)];
    const { columnCount, kinds } = this.space;
    const length = Math.max(...this.chains.map((chain) => chain.length));
    this.resistance = Float64Array.from(this.space.joints, (joint, column) => {
      const stiffness = natures.find((nature) => nature.joint === joint)?.stiffness ?? 1;
      // A slide over the length of the chain counts as much as a turn by one radian.
      const unit = kinds[column] === DofKind.slide ? stiffness / length : stiffness;
      return unit * unit;
    });
    this.gradient = new Float64Array(columnCount);
    this.squares = new Float64Array(columnCount * columnCount);
    this.curvature = new Float64Array(columnCount * columnCount);
    this.jacobian = new Float64Array(columnCount * 3);
    this.#offset = new Float64Array(columnCount);
    const heaviest = Math.max(...goals.map(({ weight }) => weight));
    this.#caps = goals.map(({ weight }) => (weight < heaviest ? residualCap : Infinity));
  }

  /** Returns the objective at q, and leaves the kinematics there. */
  cost(q: Float64Array): number {
    this.kinematics.update(q);
    return this.goalCost() + this.pull * this.secondaryCost(q);
  }

  /** The goals' part of the objective, where the kinematics is. */
  goalCost(): number {
    let sum = 0;
    for (let goal = 0; goal < this.goals.length; goal++) {
      const { weight, rotation } = this.goals[goal]!;
      const distance = this.kinematics.residual(goal) / this.chains[goal]!.length;
      const cap = this.#caps[goal]!;
      let twice = distance <= cap ? distance * distance : cap * (2 * distance - cap);
      if (rotation) {
        const turn = lengthPerRadian * this.kinematics.turn(goal);
        twice += turn * turn;
      }
      sum += 0.5 * weight * weight * twice;
    }
    return sum;
  }

  /** What the reference and the soft tasks cost in a pose, before `pull`. */
  secondaryCost(q: Float64Array): number {
    const [offset, resistance] = [this.#offset, this.resistance];
    difference(this.space, this.#reference, q, offset);
    let sum = 0;
    for (let i = 0; i < offset.length; i++) sum += 0.5 * resistance[i]! * offset[i]! * offset[i]!;
    for (let i = 0; i < this.#tasks.length; i++) sum += softWeight * this.#tasks[i]!.cost(q);
    return sum;
  }

  /** Writes the gradient and the matrices at q, where the kinematics must be. */
  linearize(q: Float64Array): void {
    const { columnCount } = this.space;
    const [offset, { pull, gradient, squares, resistance }] = [this.#offset, this];
    squares.fill(0);
    this.curvature.fill(0);
    difference(this.space, this.#reference, q, offset);
    for (let i = 0; i < columnCount; i++) {
      gradient[i] = pull * resistance[i]! * offset[i]!;
      squares[i * columnCount + i] = pull * resistance[i]!;
    }
    for (let i = 0; i < this.#tasks.length; i++)
      this.#tasks[i]!.accumulate(q, pull * softWeight, gradient, squares);
    for (let goal = 0; goal < this.goals.length; goal++) {
      this.#addPlace(goal);
      if (this.goals[goal]!.rotation) this.#addRotation(goal);
    }
  }

  /** Writes the derivatives of a goal's point by the columns that move it into `jacobian`. */
  writeJacobian(goal: number): void {
    const { axes, origins, points, columnsOf } = this.kinematics;
    const { kinds } = this.space;
    const [columns, jacobian] = [columnsOf[goal]!, this.jacobian];
    for (let i = 0; i < columns.length; i++) {
      const column = columns[i]!;
      const at = column * 3;
      const x = axes[at]!;
      const y = axes[at + 1]!;
      const z = axes[at + 2]!;
      if (kinds[column] === DofKind.slide) {
        jacobian[at] = x;
        jacobian[at + 1] = y;
        jacobian[at + 2] = z;
        continue;
      }
      const rx = points[goal * 3]! - origins[at]!;
      const ry = points[goal * 3 + 1]! - origins[at + 1]!;
      const rz = points[goal * 3 + 2]! - origins[at + 2]!;
      jacobian[at] = y * rz - z * ry;
      jacobian[at + 1] = z * rx - x * rz;
      jacobian[at + 2] = x * ry - y * rx;
    }
  }

  /**
   * Adds a goal's place. With the residual r and the columns J of its point, the gradient is Jᵀ r.
   * The second derivative of the point by an outer column of axis a and an inner one is `a × J`, so
   * that both matrices together have the elements `(J_outer + r × a) · J_inner`.
   */
  #addPlace(goal: number): void {
    const { axes, points, columnsOf } = this.kinematics;
    const { columnCount, kinds, dofs } = this.space;
    const { gradient, squares, curvature, jacobian } = this;
    const columns = columnsOf[goal]!;
    const { target, weight } = this.goals[goal]!;
    const { length } = this.chains[goal]!;
    const [rx, ry, rz] = [
      points[goal * 3]! - target[0],
      points[goal * 3 + 1]! - target[1],
      points[goal * 3 + 2]! - target[2],
    ];
    const distance = Math.sqrt(rx * rx + ry * ry + rz * rz) / length;
    const held = Math.min(1, this.#caps[goal]! / Math.max(distance, 1e-300));
    const scale = (held * weight * weight) / (length * length);
    this.writeJacobian(goal);
    for (let i = 0; i < columns.length; i++) {
      const outer = columns[i]!;
      const o = outer * 3;
      const ox = jacobian[o]!;
      const oy = jacobian[o + 1]!;
      const oz = jacobian[o + 2]!;
      gradient[outer] = gradient[outer]! + scale * (ox * rx + oy * ry + oz * rz);
      const isSlide = kinds[outer] === DofKind.slide;
      const isBall = kinds[outer] === DofKind.ball;
      const mx = isSlide ? 0 : ry * axes[o + 2]! - rz * axes[o + 1]!;
      const my = isSlide ? 0 : rz * axes[o]! - rx * axes[o + 2]!;
      const mz = isSlide ? 0 : rx * axes[o + 1]! - ry * axes[o]!;
      for (let k = i; k < columns.length; k++) {
        const inner = columns[k]!;
        const n = inner * 3;
        const nx = jacobian[n]!;
        const ny = jacobian[n + 1]!;
        const nz = jacobian[n + 2]!;
        const at = inner * columnCount + outer;
        squares[at] = squares[at]! + scale * (ox * nx + oy * ny + oz * nz);
        let second = mx * nx + my * ny + mz * nz;
        if (isBall && dofs[inner] === dofs[outer]) {
          // Two axes of one ball turn at the same time: neither is the outer one.
          const sx = ry * axes[n + 2]! - rz * axes[n + 1]!;
          const sy = rz * axes[n]! - rx * axes[n + 2]!;
          const sz = rx * axes[n + 1]! - ry * axes[n]!;
          second = 0.5 * (second + sx * ox + sy * oy + sz * oz);
        }
        curvature[at] = curvature[at]! + scale * second;
      }
    }
  }

  /** Adds a goal's orientation: the rotation vector from it, whose columns are the axes. */
  #addRotation(goal: number): void {
    const { axes, columnsOf, characterFromJoint } = this.kinematics;
    const { columnCount, kinds } = this.space;
    const { gradient, squares } = this;
    const { joint, rotation, weight } = this.goals[goal]!;
    const [columns, turn] = [columnsOf[goal]!, this.#turn];
    turnBetween(rotation!, characterFromJoint, joint * 16, turn);
    const scale = weight * weight * lengthPerRadian * lengthPerRadian;
    for (let i = 0; i < columns.length; i++) {
      const outer = columns[i]!;
      if (kinds[outer] === DofKind.slide) continue;
      const x = axes[outer * 3]!;
      const y = axes[outer * 3 + 1]!;
      const z = axes[outer * 3 + 2]!;
      const along = x * turn[0]! + y * turn[1]! + z * turn[2]!;
      gradient[outer] = gradient[outer]! + scale * along;
      for (let k = i; k < columns.length; k++) {
        const inner = columns[k]!;
        if (kinds[inner] === DofKind.slide) continue;
        const n = inner * 3;
        const at = inner * columnCount + outer;
        squares[at] = squares[at]! + scale * (x * axes[n]! + y * axes[n + 1]! + z * axes[n + 2]!);
      }
    }
  }
}

/** How much a radian outside a natural range counts against a radian from the reference, squared. */
const softWeight = 100;
