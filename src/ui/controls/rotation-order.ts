import { axisDofs } from '../../core/pose.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { ballValue } from '../../formats/ball-values.ts';

/**
 * "R = Rx · Ry · Rz", read off a joint's hinges, or that of a ball's angles; empty where no joint has
 * three.
 */
export function rotationOrder(skeleton: Skeleton): string {
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    if (ballValue(skeleton, joint) >= 0) return 'R = Rx · Ry · Rz';
    const hinges = axisDofs(skeleton, joint).filter(({ kind }) => kind === DofKind.hinge);
    if (hinges.length < 3) continue;
    return `R = ${hinges.map(({ axis }) => `R${'xyz'[axis]!}`).join(' · ')}`;
  }
  return '';
}
