import type { DiagnosticLog } from '../core/diagnostics.ts';
import { axisDofs, type AxisDof, type Pose } from '../core/pose.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';

const axisNames = ['x', 'y', 'z'];

/**
 * Sets a joint's hinges or slides about x, y and z. Says so where a value is past its limits, which
 * is clamped, or where the joint has no freedom for it.
 *
 * @param joint -1 where there is none
 */
export function setAxisValues(
  skeleton: Skeleton,
  pose: Pose,
  joint: number,
  kind: AxisDof['kind'],
  values: readonly number[],
  log: DiagnosticLog,
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
    log.warn({
      code: 'pose/ignored',
      expected: `no ${axisNames[axis]!} for ${jointText()}, which does not ${verb} it`,
      found: `${value}`,
      effect: 'the value is left out',
    });
  }

  function reportClamped(
    value: number,
    axis: number,
    [low, high]: readonly [number, number],
    used: number,
  ): void {
    log.warn({
      code: 'pose/range',
      expected: `${axisNames[axis]!} of ${jointText()} from ${low} to ${high}`,
      found: `${value}`,
      effect: `${used} is used`,
    });
  }

  function jointText(): string {
    return joint < 0 ? 'the root' : `"${skeleton.names[joint]!}"`;
  }
}
