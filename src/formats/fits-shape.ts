import type { Character } from '../core/character.ts';
import { DofKind, noParent, type Skeleton } from '../core/skeleton.ts';
import { largestInfluenceCount } from '../core/skin.ts';
import type { FormatShape } from './format.ts';

/** Whether the character already has the shape of that format's files. */
export function fitsShape({ skeleton, skin }: Character, shape: FormatShape): boolean {
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    if (!jointFits(skeleton, joint, shape)) return false;
  }
  if (!shape.bindings && skin.bindFromJoint) return false;
  if (largestInfluenceCount(skin) > shape.influences) return false;
  return shape.restPose || isUnposed(skeleton);
}

function jointFits(skeleton: Skeleton, joint: number, shape: FormatShape): boolean {
  if (!shape.restRotations && Math.abs(skeleton.restRotations[joint * 4 + 3]!) !== 1) return false;
  const from = skeleton.dofStart[joint]!;
  const kinds = [...skeleton.dofKind.subarray(from, skeleton.dofStart[joint + 1])];
  const isRoot = skeleton.parents[joint] === noParent;
  const slides = isRoot || (shape.slides === 'any' && kinds[0] === DofKind.slide);
  const wanted = [...(slides ? axisDofs(DofKind.slide, 'xyz') : []), ...turnsOf(shape)];
  return (
    kinds.length === wanted.length &&
    wanted.every(({ kind, axis }, i) => {
      const fits = axis === undefined || skeleton.dofAxis[(from + i) * 3 + axis] === 1;
      return kind === kinds[i] && fits;
    })
  );
}

interface WantedDof {
  readonly kind: DofKind;
  /** Absent for a ball. */
  readonly axis?: number;
}

function turnsOf({ turns }: FormatShape): WantedDof[] {
  return turns === 'ball' ? [{ kind: DofKind.ball }] : axisDofs(DofKind.hinge, turns);
}

function axisDofs(kind: DofKind, axes: string): WantedDof[] {
  return Array.from(axes, (axis) => ({ kind, axis: 'xyz'.indexOf(axis) }));
}

/** Whether no joint is translated or rotated at rest. A ball's identity is (0, 0, 0, 1). */
function isUnposed({ qRest, jointCount, dofStart, dofKind, dofQ }: Skeleton): boolean {
  const ones = new Set<number>();
  for (let dof = 0; dof < dofStart[jointCount]!; dof++) {
    if (dofKind[dof] === DofKind.ball) ones.add(dofQ[dof]! + 3);
  }
  return qRest.every((value, i) => value === (ones.has(i) ? 1 : 0));
}
