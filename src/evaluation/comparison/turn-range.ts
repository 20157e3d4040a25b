import { quat } from 'gl-matrix';
import { axisDofs } from '../../core/pose.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';

/** An axis about which a joint turns alone, and how far. */
export interface TurnRange {
  readonly joint: number;
  readonly axis: 0 | 1 | 2;
  /** In radians: the limits of the hinge, or half a turn each way. */
  readonly from: number;
  readonly to: number;
  /** The index in q of the hinge's angle or the ball's quaternion. */
  readonly index: number;
  readonly ofBall: boolean;
}

const axes = [0, 1, 2] as const;

/** Returns the axes of a joint: those of its hinges that can turn, or all three of its ball. */
export function turnRanges(skeleton: Skeleton, joint: number): TurnRange[] {
  const { dofStart, dofKind, dofQ, qMin, qMax } = skeleton;
  const ranges = axisDofs(skeleton, joint)
    .filter(({ kind }) => kind === DofKind.hinge)
    .map(({ axis, index }): TurnRange => {
      const [from, to] = [finite(qMin[index]!, -Math.PI), finite(qMax[index]!, Math.PI)];
      return { joint, axis, from, to, index, ofBall: false };
    });
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    if (dofKind[dof] !== DofKind.ball) continue;
    const ball = { joint, from: -Math.PI, to: Math.PI, index: dofQ[dof]!, ofBall: true };
    ranges.push(...axes.map((axis) => ({ ...ball, axis })));
  }
  return ranges.filter(({ from, to }) => from < to).sort((a, b) => a.axis - b.axis);
}

function finite(limit: number, otherwise: number): number {
  return Number.isFinite(limit) ? limit : otherwise;
}

/** Returns the pose with the joint turned about the axis alone, from where the file has a ball. */
export function turned(
  { qRest }: Skeleton,
  q: Float64Array,
  { axis, index, ofBall }: TurnRange,
  angle: number,
): Float64Array {
  const changed = q.slice();
  if (!ofBall) {
    changed[index] = angle;
    return changed;
  }
  const about: [number, number, number] = [0, 0, 0];
  about[axis] = 1;
  const turn = quat.setAxisAngle([0, 0, 0, 1], about, angle);
  changed.set(quat.multiply([0, 0, 0, 1], qRest.subarray(index, index + 4), turn), index);
  return changed;
}
