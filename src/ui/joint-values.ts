import { axisDofs } from '../core/pose.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import { ballValue } from '../formats/ball-values.ts';

/** A number of a joint that users set: a slide, a hinge, or one of the three angles of a ball. */
export interface JointValue {
  readonly isAngle: boolean;
  readonly axis: 0 | 1 | 2;
  /** Its index in q; for an angle of a ball, where the ball's four values start. */
  readonly index: number;
  readonly ofBall: boolean;
}

const axes = [0, 1, 2] as const;
export const axisNames = ['X', 'Y', 'Z'] as const;

/** Lists slides before angles, each by axis, regardless of the order in which they are applied. */
export function jointValues(skeleton: Skeleton, joint: number): JointValue[] {
  const ball = ballValue(skeleton, joint);
  const values = axisDofs(skeleton, joint).map(({ kind, axis, index }): JointValue => {
    return { isAngle: kind === DofKind.hinge, axis, index, ofBall: false };
  });
  if (ball >= 0) {
    values.push(...axes.map((axis) => ({ isAngle: true, axis, index: ball, ofBall: true })));
  }
  return values.sort((a, b) => Number(a.isAngle) - Number(b.isAngle) || a.axis - b.axis);
}

/** The name in the interface, such as "X" or "Move Y". */
export function valueName({ isAngle, axis }: JointValue): string {
  return `${isAngle ? '' : 'Move '}${axisNames[axis]}`;
}
