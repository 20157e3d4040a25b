import { mat3, quat, vec3 } from 'gl-matrix';
import { diagonal, emptyBounds, includePositions } from '../../core/bounds.ts';
import { jointMatrices } from '../../core/forward-kinematics.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { subtreeEnd } from '../../core/subtree.ts';
import { pathTo } from './chain.ts';
import type { IkGoal, IkProblem, JointNature, Quaternion, Vector3 } from './problem.ts';

/** A chain as it is dragged. Everything is in the character's space. */
export interface ChainParts {
  readonly skeleton: Skeleton;
  /** (qCount) the pose, to which the null space pulls. */
  readonly q: Float64Array;
  readonly joint: number;
  /** The dragged point, in the joint's frame. */
  readonly point: Vector3;
  /** How many joints the chain has. */
  readonly count: number;
  /** The goals that hold other joints. */
  readonly held: readonly IkGoal[];
  readonly natures: readonly JointNature[];
}

/** What dragging a chain asks of a solver. */
export interface ChainProblem {
  /** From the joint that begins the chain to the one that is dragged. */
  readonly chain: readonly number[];
  /** All joints that may change, ascending. */
  readonly joints: readonly number[];
  /** The length of the chain, or the size of the skeleton where a slide moves all of it. */
  readonly reach: number;
  toward(target: Vector3, reference: Float64Array): IkProblem;
  placeIn(q: Float64Array): Vector3;
  /** Where the chain begins, in the pose of the start. */
  readonly begin: Vector3;
}

/**
 * Returns the problem of a chain. A joint that slides and is dragged alone keeps its orientation;
 * slides are free there, and where goals hold what hangs on the chain. These goals take part with
 * the joints between them and the chain, so that a pelvis can be dragged over feet that stay.
 */
export function chainProblem(parts: ChainParts): ChainProblem {
  const { skeleton, q, joint, point, count, natures } = parts;
  const chain = pathTo(skeleton, joint).slice(-count);
  const first = chain[0]!;
  const matrices = jointMatrices(skeleton, q);
  const hanging = parts.held.filter(
    (goal) =>
      goal.joint > first && goal.joint < subtreeEnd(skeleton, first) && goal.joint !== joint,
  );
  const isAlone = chain.length === 1 && slidesOf(skeleton, joint).length > 0;
  const joints = new Set(chain);
  for (const goal of hanging) {
    const below = goal.rotation ? goal.joint : skeleton.parents[goal.joint]!;
    for (let each = below; each > first && !joints.has(each); each = skeleton.parents[each]!) {
      joints.add(each);
    }
  }
  const slides = isAlone || hanging.length > 0;
  const solved = slides ? skeleton : withoutSlides(skeleton, q, joints);
  const sorted = [...joints].sort((a, b) => a - b);
  const rotation = isAlone ? { rotation: rotationOf(matrices, joint) } : {};
  return {
    chain,
    joints: sorted,
    reach: slides ? sizeOf(matrices) : lengthOf(chain, matrices, point),
    begin: originOf(matrices, first),
    toward: (target, reference) => ({
      skeleton: solved,
      goals: [{ joint, point, target, weight: 1, ...rotation }, ...hanging],
      joints: sorted,
      reference,
      natures,
    }),
    placeIn: (pose) => placeOf(jointMatrices(skeleton, pose), joint, point),
  };
}

/** The indices in q of a joint's slides. */
export function slidesOf({ dofStart, dofKind, dofQ }: Skeleton, joint: number): number[] {
  const found: number[] = [];
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    if (dofKind[dof] === DofKind.slide) found.push(dofQ[dof]!);
  }
  return found;
}

/** The same skeleton, in which the slides of some joints are locked at their values. */
function withoutSlides(skeleton: Skeleton, q: Float64Array, joints: ReadonlySet<number>): Skeleton {
  const locked = [...joints].flatMap((joint) => slidesOf(skeleton, joint));
  if (locked.length === 0) return skeleton;
  const [qMin, qMax] = [skeleton.qMin.slice(), skeleton.qMax.slice()];
  for (const index of locked) qMin[index] = qMax[index] = q[index]!;
  return { ...skeleton, qMin, qMax };
}

/** The place of a point of a joint, in the character's space. */
export function placeOf(matrices: Float64Array, joint: number, point: Vector3): Vector3 {
  const matrix = matrices.subarray(joint * 16, joint * 16 + 16);
  const [x, y, z] = vec3.transformMat4(new Float64Array(3), [...point], matrix);
  return [x!, y!, z!];
}

function originOf(matrices: Float64Array, joint: number): Vector3 {
  return placeOf(matrices, joint, [0, 0, 0]);
}

function rotationOf(matrices: Float64Array, joint: number): Quaternion {
  const matrix = matrices.subarray(joint * 16, joint * 16 + 16);
  // Not `mat4.getRotation`, which alone would make the first scripts larger.
  const rotation = mat3.fromMat4(new Float64Array(9), matrix);
  const [x, y, z, w] = quat.fromMat3(new Float64Array(4), rotation) as Float64Array;
  return [x!, y!, z!, w!];
}

function lengthOf(chain: readonly number[], matrices: Float64Array, point: Vector3): number {
  const places = chain.map((joint) => originOf(matrices, joint));
  places.push(placeOf(matrices, chain.at(-1)!, point));
  return places
    .slice(1)
    .reduce((sum, place, i) => sum + vec3.distance([...place], [...places[i]!]), 0);
}

/** The diagonal of the box of all joints. */
function sizeOf(matrices: Float64Array): number {
  const box = emptyBounds();
  for (let at = 12; at < matrices.length; at += 16) {
    includePositions(box, matrices.subarray(at, at + 3), 1);
  }
  return diagonal(box);
}
