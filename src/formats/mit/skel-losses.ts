import type { Diagnostic } from '../../core/diagnostics.ts';
import { jointRange } from '../../core/pose.ts';
import { DofKind, noParent, type Skeleton } from '../../core/skeleton.ts';
import { jointNames } from './joint-names.ts';
import { reportLosses } from './losses.ts';
import { parentInFile, standsTurned } from './write-skel.ts';

/** Returns what a `.skel` can't hold of a skeleton. */
export function skelLosses(file: string, skeleton: Skeleton): readonly Diagnostic[] {
  const readNames = jointNames(
    Array.from(skeleton.jointOfSource, (joint) => parentInFile(skeleton, joint)),
  );
  const countJoints = (has: (joint: number) => boolean): number =>
    skeleton.jointOfSource.filter((joint) => has(joint)).length;
  return reportLosses(file, 'skel/lost', [
    {
      what: 'rest rotations and poses of joints',
      count: countJoints((joint) => standsTurned(skeleton, joint)),
      effect: 'joints keep their places; their axes are those of the world at rest',
    },
    {
      what: 'degrees of freedom of joints',
      count: countJoints((joint) => !hasFreedomsOfFormat(skeleton, joint)),
      effect: 'each joint turns about x, y and z, and roots move',
    },
    {
      what: 'limits of joints',
      count: countJoints((joint) => hasLimits(skeleton, joint)),
      effect: 'joints turn without limits',
    },
    {
      what: 'names of joints',
      count: countJoints(
        (joint) => skeleton.names[joint] !== readNames[skeleton.sourceIndex[joint]!],
      ),
      effect: 'joints are named by their number',
    },
  ]);
}

function hasLimits(skeleton: Skeleton, joint: number): boolean {
  const { qMin, qMax } = skeleton;
  const [from, to] = jointRange(skeleton, joint);
  return [...qMin.subarray(from, to), ...qMax.subarray(from, to)].some(Number.isFinite);
}

/**
 * Whether the joint has hinges about x, y and z and, at a root, slides along x, y and z before
 * them.
 */
function hasFreedomsOfFormat(skeleton: Skeleton, joint: number): boolean {
  const { dofStart, dofKind, dofAxis, parents } = skeleton;
  const [from, to] = [dofStart[joint]!, dofStart[joint + 1]!];
  const kinds = parents[joint] === noParent ? [DofKind.slide, DofKind.hinge] : [DofKind.hinge];
  if (to - from !== kinds.length * 3) return false;
  for (let dof = from; dof < to; dof++) {
    const at = dof - from;
    if (dofKind[dof] !== kinds[Math.floor(at / 3)]) return false;
    for (let i = 0; i < 3; i++) {
      if (dofAxis[dof * 3 + i] !== (i === at % 3 ? 1 : 0)) return false;
    }
  }
  return true;
}
