import { axisDofs } from '../../core/pose.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';

/** "R = Rx · Ry · Rz", read off a joint's hinges; empty where no joint has three. */
export function rotationOrder(skeleton: Skeleton): string {
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const hinges = axisDofs(skeleton, joint).filter(({ kind }) => kind === DofKind.hinge);
    if (hinges.length < 3) continue;
    return `R = ${hinges.map(({ axis }) => `R${'xyz'[axis]!}`).join(' · ')}`;
  }
  return '';
}
