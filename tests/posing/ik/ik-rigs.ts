import { buildSkeleton } from '../../../src/core/build-skeleton.ts';
import type { DofParts, JointParts } from '../../../src/core/character-parts.ts';
import { DiagnosticLog } from '../../../src/core/diagnostics.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { DofKind, type Skeleton } from '../../../src/core/skeleton.ts';
import type { IkGoal, IkProblem, Vector3 } from '../../../src/posing/ik/problem.ts';
import { readBundled } from '../../support/bundled.ts';
import { randomBetween } from '../../support/random.ts';

type Limits = readonly [number, number];
type AxisName = 'x' | 'y' | 'z';

const axes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const;

export function hinge(axis: AxisName, limits?: Limits): DofParts {
  return { kind: DofKind.hinge, axis: axes[axis], ...(limits && { limits }) };
}

export function slide(axis: AxisName, limits?: Limits): DofParts {
  return { kind: DofKind.slide, axis: axes[axis], ...(limits && { limits }) };
}

export const ball: DofParts = { kind: DofKind.ball, axis: [0, 0, 0] };

export function triple(limits?: Limits): DofParts[] {
  return [hinge('x', limits), hinge('y', limits), hinge('z', limits)];
}

/** A joint of a rig: its parent, its offset and its degrees of freedom, the outermost first. */
export type RigJoint = readonly [parent: number, offset: Vector3, dofs: readonly DofParts[]];

export function skeletonOf(joints: readonly RigJoint[]): Skeleton {
  const parts = joints.map(([parent, restOffset, dofs], index): JointParts => ({
    ...{ name: `#${index}`, parent, restOffset, dofs },
  }));
  return buildSkeleton({ file: 'rig', joints: parts }, new DiagnosticLog('rig'))!;
}

/** A skeleton, what is to be moved by which joints, and the ranges that random poses are taken from. */
export interface IkRig {
  readonly skeleton: Skeleton;
  /** The points to be moved; their targets are replaced. */
  readonly goals: readonly IkGoal[];
  readonly joints: readonly number[];
  /** Where reachable targets come from: the range of a value of q. */
  readonly rangeOf: (value: number) => Limits;
  /** (qCount) where solves start. */
  readonly start: Float64Array;
}

export function goalAt(joint: number, point: Vector3, weight = 1): IkGoal {
  return { joint, point, target: [0, 0, 0], weight };
}

export function problemOf(rig: IkRig, goals: readonly IkGoal[]): IkProblem {
  const { skeleton, joints, start } = rig;
  return { skeleton, goals, joints, reference: start, natures: [] };
}

/** A reachable target for each goal: where the goals' points are in a random pose. */
export function reachableGoals(rig: IkRig, random: () => number): IkGoal[] {
  const q = rig.start.map((value, index) => {
    const [min, max] = rig.rangeOf(index);
    return min === max ? value : randomBetween(random, min, max);
  });
  return goalsAt(rig, q);
}

/** The rig's goals, with their points' places in a pose as targets. */
export function goalsAt({ skeleton, goals }: IkRig, q: Float64Array): IkGoal[] {
  return goals.map((goal) => ({ ...goal, target: placeOf(skeleton, q, goal.joint, goal.point) }));
}

export function placeOf(
  skeleton: Skeleton,
  q: Float64Array,
  joint: number,
  [x, y, z]: Vector3,
): [number, number, number] {
  const m = jointMatrices(skeleton, q).subarray(joint * 16, joint * 16 + 16);
  const row = (r: number): number => m[r]! * x + m[r + 4]! * y + m[r + 8]! * z + m[r + 12]!;
  return [row(0), row(1), row(2)];
}

/** Six balls of three hinges each, every one of them within ±0.7. */
export function sixBalls(): IkRig {
  const limits = [-0.7, 0.7] as const;
  const offsets = [
    [0, 0, 0],
    [0, 0.3, 0],
    [0.05, 0.3, 0],
    [0, 0.25, 0.05],
    [0, 0.25, 0],
    [0, 0.2, 0],
  ] as const;
  const skeleton = skeletonOf(offsets.map((offset, joint) => [joint - 1, offset, triple(limits)]));
  return {
    skeleton,
    goals: [goalAt(5, [0, 0.2, 0])],
    joints: [0, 1, 2, 3, 4, 5],
    rangeOf: () => limits,
    start: skeleton.qRest,
  };
}

/** A hip of three hinges, and a knee and an ankle that bend one way; the leg starts straight. */
export function leg(): IkRig {
  const skeleton = skeletonOf([
    [-1, [0, 1, 0], [hinge('x', [-1.8, 0.6]), hinge('y', [-0.6, 0.6]), hinge('z', [-0.7, 0.7])]],
    [0, [0, -0.45, 0], [hinge('x', [0, 2.4])]],
    [1, [0, -0.45, 0], [hinge('x', [-0.5, 0.7])]],
  ]);
  return {
    skeleton,
    goals: [goalAt(2, [0, 0, 0])],
    joints: [0, 1],
    rangeOf: (value) => [skeleton.qMin[value]!, skeleton.qMax[value]!],
    start: skeleton.qRest,
  };
}

/** Both hands of the bundled human, with its feet pinned; its root can slide and turn. */
export async function handsAndFeet(): Promise<IkRig> {
  const { skeleton } = await readBundled('human');
  const at = (name: string): number => skeleton.names.indexOf(name);
  const spine = ['Lower back', 'Spine', 'Chest'].map(at);
  const limbs = ['Right', 'Left'].flatMap((side) =>
    ['shoulder', 'upper arm', 'forearm', 'upper leg', 'lower leg'].map((name) => {
      return at(`${side} ${name}`);
    }),
  );
  const bent = new Map([...spine, ...limbs].map((joint) => [joint, 0.25]));
  for (const side of ['Right', 'Left']) {
    bent.set(at(`${side} shoulder`), 0.1);
    for (const name of ['upper arm', 'forearm']) bent.set(at(`${side} ${name}`), 0.9);
    for (const name of ['upper leg', 'lower leg']) bent.set(at(`${side} ${name}`), 0);
  }
  const ranges = new Map<number, Limits>();
  for (const [joint, angle] of bent)
    for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++)
      ranges.set(skeleton.dofQ[dof]!, [-angle, angle]);
  return {
    skeleton,
    goals: [
      goalAt(at('Right hand'), [0, 0, 0]),
      goalAt(at('Left hand'), [0, 0, 0]),
      goalAt(at('Right foot'), [0, 0, 0], 10),
      goalAt(at('Left foot'), [0, 0, 0], 10),
    ],
    joints: [at('Root'), ...spine, ...limbs].sort((a, b) => a - b),
    rangeOf: (value) => ranges.get(value) ?? [0, 0],
    start: skeleton.qRest,
  };
}
