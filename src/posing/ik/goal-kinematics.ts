import { forwardKinematics } from '../../core/forward-kinematics.ts';
import { applyDof, applyRest } from '../../core/joint-transforms.ts';
import { DofKind, noParent, type Skeleton } from '../../core/skeleton.ts';
import type { IkGoal } from './problem.ts';
import { turnBetween } from './quaternions.ts';
import type { TangentSpace } from './tangent-space.ts';

/**
 * Where the goals' points are, and how the columns move them. It visits only the joints between the
 * goals and the outermost joints with columns, and allocates only when it is made.
 */
export class GoalKinematics {
  /** (columnCount × 3) unit vectors in the character's space: the axis of rotation, or of sliding. */
  readonly axes: Float64Array;
  /** (columnCount × 3) a point on the axis of rotation. */
  readonly origins: Float64Array;
  /** (goalCount × 3) the goals' points in the character's space. */
  readonly points: Float64Array;
  /** (goals, then its columns) the columns that move each goal, the outermost first. */
  readonly columnsOf: readonly Uint16Array[];
  readonly space: TangentSpace;
  readonly goals: readonly IkGoal[];
  /** (jointCount × 16) of all joints once, and then only of those that are visited. */
  readonly characterFromJoint: Float64Array;
  readonly #skeleton: Skeleton;
  /** The joints whose matrices change, ascending. */
  readonly #visited: Uint16Array;
  /** (visited) the first column of each visited joint. */
  readonly #firstColumn: Uint16Array;
  readonly #world = new Float64Array(16);
  readonly #turn = new Float64Array(3);

  /** @param q (qCount) what the joints that never move are computed from */
  constructor(skeleton: Skeleton, goals: readonly IkGoal[], space: TangentSpace, q: Float64Array) {
    this.#skeleton = skeleton;
    this.space = space;
    this.goals = goals;
    const { columnCount, joints } = space;
    this.axes = new Float64Array(columnCount * 3);
    this.origins = new Float64Array(columnCount * 3);
    this.points = new Float64Array(goals.length * 3);
    this.characterFromJoint = new Float64Array(skeleton.jointCount * 16);
    forwardKinematics(skeleton, q, this.characterFromJoint);
    const chains = goals.map(({ joint }) => ancestors(skeleton, joint));
    const above = new Set(chains.flat());
    this.columnsOf = chains.map((chain) => {
      const isAbove = new Set(chain);
      const columns = Array.from(joints.keys()).filter((column) => isAbove.has(joints[column]!));
      return Uint16Array.from(columns);
    });
    const moving = new Set(joints);
    const visited: number[] = [];
    // Joints are sorted depth first, so a parent has been decided before its children.
    for (const joint of [...above].sort((a, b) => a - b)) {
      if (moving.has(skeleton.parents[joint]!)) moving.add(joint);
      if (moving.has(joint)) visited.push(joint);
    }
    this.#visited = Uint16Array.from(visited);
    this.#firstColumn = Uint16Array.from(visited, (joint) => {
      const first = joints.findIndex((each) => each >= joint);
      return first === -1 ? columnCount : first;
    });
  }

  /** Computes the points of the goals, and the axes and origins of the columns that move them. */
  update(q: Float64Array): void {
    const { parents, dofStart } = this.#skeleton;
    const { columnCount, dofs } = this.space;
    const [visited, world, matrices] = [this.#visited, this.#world, this.characterFromJoint];
    for (let i = 0; i < visited.length; i++) {
      const joint = visited[i]!;
      const parent = parents[joint]!;
      for (let k = 0; k < 16; k++)
        world[k] = parent === noParent ? identity[k]! : matrices[parent * 16 + k]!;
      applyRest(this.#skeleton, joint, world);
      let column = this.#firstColumn[i]!;
      const end = dofStart[joint + 1]!;
      for (let dof = dofStart[joint]!; dof < end; dof++) {
        while (column < columnCount && dofs[column] === dof) this.#writeColumn(column++);
        applyDof(this.#skeleton, dof, q, world);
      }
      for (let k = 0; k < 16; k++) matrices[joint * 16 + k] = world[k]!;
    }
    for (let goal = 0; goal < this.goals.length; goal++) this.#writePoint(goal);
  }

  /** The distance of a goal's point from its target, in model units. */
  residual(goal: number): number {
    const { target } = this.goals[goal]!;
    const x = this.points[goal * 3]! - target[0];
    const y = this.points[goal * 3 + 1]! - target[1];
    const z = this.points[goal * 3 + 2]! - target[2];
    return Math.sqrt(x * x + y * y + z * z);
  }

  /** The angle from a goal's orientation in radians; 0 if it has none. */
  turn(goal: number): number {
    const { joint, rotation } = this.goals[goal]!;
    if (!rotation) return 0;
    const turn = this.#turn;
    turnBetween(rotation, this.characterFromJoint, joint * 16, turn);
    return Math.sqrt(turn[0]! * turn[0]! + turn[1]! * turn[1]! + turn[2]! * turn[2]!);
  }

  #writeColumn(column: number): void {
    const { dofs, kinds, axes } = this.space;
    const world = this.#world;
    const { dofAxis } = this.#skeleton;
    const at = column * 3;
    for (let row = 0; row < 3; row++) {
      this.origins[at + row] = world[12 + row]!;
      if (kinds[column] === DofKind.ball) {
        this.axes[at + row] = world[axes[column]! * 4 + row]!;
        continue;
      }
      const own = dofs[column]! * 3;
      this.axes[at + row] =
        world[row]! * dofAxis[own]! +
        world[4 + row]! * dofAxis[own + 1]! +
        world[8 + row]! * dofAxis[own + 2]!;
    }
  }

  #writePoint(goal: number): void {
    const { joint, point } = this.goals[goal]!;
    const [m, from] = [this.characterFromJoint, joint * 16];
    const [x, y, z] = point;
    for (let row = 0; row < 3; row++) {
      this.points[goal * 3 + row] =
        m[from + row]! * x + m[from + 4 + row]! * y + m[from + 8 + row]! * z + m[from + 12 + row]!;
    }
  }
}

const identity = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

/** The joint and all joints above it. */
function ancestors({ parents }: Skeleton, joint: number): number[] {
  const found: number[] = [];
  for (let each = joint; each !== noParent; each = parents[each]!) found.push(each);
  return found;
}
