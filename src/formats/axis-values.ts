import { axisDofs, type AxisDof, type Pose } from '../core/pose.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import type { JsonValue } from './json/decoder.ts';

const axisNames = ['x', 'y', 'z'];

/**
 * Sets a joint's hinges or slides about x, y and z. Reports a value that exceeds its limits, which
 * is clamped, and a value for an axis that the joint does not have.
 *
 * @param joint -1 if there is none
 * @param json the values with their places in the text, for messages
 */
export function setAxisValues(
  skeleton: Skeleton,
  pose: Pose,
  joint: number,
  kind: AxisDof['kind'],
  values: readonly number[],
  json: JsonValue,
): void {
  const dofs = joint < 0 ? [] : axisDofs(skeleton, joint).filter((dof) => dof.kind === kind);
  values.forEach((value, axis) => {
    const own = dofs.filter((dof) => dof.axis === axis);
    if (own.length === 0 && value !== 0) reportMissing(value, axis);
    for (const { index } of own) {
      const [low, high] = [skeleton.qMin[index]!, skeleton.qMax[index]!];
      pose.q[index] = Math.min(Math.max(value, low), high);
      if (pose.q[index] !== value) reportClamped(value, axis, [low, high], pose.q[index]);
    }
  });

  function reportMissing(value: number, axis: number): void {
    const verb = kind === DofKind.hinge ? 'turn about' : 'move along';
    json
      .member(axis)
      .warn(
        'ignored',
        `no ${axisNames[axis]!} for ${jointText()}, which does not ${verb} it`,
        `${value}`,
        'the value is left out',
      );
  }

  function reportClamped(
    value: number,
    axis: number,
    [low, high]: readonly [number, number],
    used: number,
  ): void {
    json
      .member(axis)
      .warn(
        'range',
        `${axisNames[axis]!} of ${jointText()} from ${low} to ${high}`,
        `${value}`,
        `${used} is used`,
      );
  }

  function jointText(): string {
    return joint < 0 ? 'the root' : `"${skeleton.names[joint]!}"`;
  }
}
