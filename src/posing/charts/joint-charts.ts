import { bonesOf } from '../../core/bones.ts';
import type { Character } from '../../core/character.ts';
import type { Quaternion } from '../../core/motion/clip-parts.ts';
import { jointRotation } from '../../core/motion/joint-rotation.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import type { RotationChart } from './chart.ts';
import { type EulerAxis, eulerChart } from './euler-chart.ts';
import { rotationVectorChart } from './rotation-vector-chart.ts';
import { swingTwistChart } from './swing-twist-chart.ts';

/** How the rotations of one joint are written as numbers. */
export interface JointCharts {
  /** In the order in which they are shown; without Euler angles if its hinges are not square. */
  readonly charts: readonly RotationChart[];
  /** The joint at the end of the bone about which the twist is; -1 is a derived tip. */
  readonly boneEnd: number;
  /** Where the angles of the Euler chart stand in q; null if the joint has a ball. */
  readonly angles: readonly number[] | null;
}

/** Returns the charts of a joint, or null if it can't turn. */
export function jointCharts(character: Character, joint: number): JointCharts | null {
  const { skeleton } = character;
  const turning = turningDofs(skeleton, joint);
  if (turning.length === 0) return null;
  const isBall = turning.some((dof) => skeleton.dofKind[dof] === DofKind.ball);
  const hinges = isBall ? coordinateAxes : turning.map((dof) => hingeOf(skeleton, dof));
  const bone = bonesOf(character).find((each) => each.joint === joint);
  const [x, y, z] = bone?.vector ?? [0, 1, 0];
  const length = Math.hypot(x, y, z);
  return {
    charts: [
      ...((isBall && turning.length > 1) || !areSquare(hinges) ? [] : [eulerChart(hinges)]),
      swingTwistChart([x / length, y / length, z / length]),
      rotationVectorChart,
    ],
    boneEnd: bone?.child ?? -1,
    angles: isBall ? null : turning.map((dof) => skeleton.dofQ[dof]!),
  };
}

/** The product of a joint's own turns, R₁ · R₂ · …, as a unit quaternion xyzw. */
export function ownRotation(skeleton: Skeleton, joint: number, q: Float64Array): Quaternion {
  const rotation = new Float64Array(4);
  jointRotation(skeleton, joint, q, rotation);
  const [x, y, z, w] = rotation;
  return [x!, y!, z!, w!];
}

function turningDofs({ dofStart, dofKind }: Skeleton, joint: number): number[] {
  const dofs: number[] = [];
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    if (dofKind[dof] !== DofKind.slide) dofs.push(dof);
  }
  return dofs;
}

const coordinateAxes: readonly EulerAxis[] = [
  { name: 'X', axis: [1, 0, 0] },
  { name: 'Y', axis: [0, 1, 0] },
  { name: 'Z', axis: [0, 0, 1] },
];

function hingeOf(skeleton: Skeleton, dof: number): EulerAxis {
  const axis = axisOf(skeleton, dof);
  const known = coordinateAxes.find((each) => each.axis.every((part, i) => part === axis[i]));
  return known ?? { name: `(${axis.map((part) => part.toFixed(2)).join(', ')})`, axis };
}

function axisOf({ dofAxis }: Skeleton, dof: number): readonly [number, number, number] {
  return [dofAxis[dof * 3]!, dofAxis[dof * 3 + 1]!, dofAxis[dof * 3 + 2]!];
}

/** Whether there are at most three axes, all at right angles. */
function areSquare(hinges: readonly EulerAxis[]): boolean {
  return (
    hinges.length <= 3 &&
    hinges.every(({ axis: a }, i) =>
      hinges.slice(i + 1).every(({ axis: b }) => Math.abs(cosine(a, b)) < 1e-9),
    )
  );
}

function cosine(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, each, i) => sum + each * b[i]!, 0);
}
