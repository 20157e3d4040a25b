import { axisDofs } from '../../core/pose.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { ballValue } from '../../formats/ball-values.ts';

/**
 * The text "R = Rx · Ry · Rz" for the order of a joint's hinges or of a ball's angles; empty if no
 * joint has three angles.
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
