import type { JointParts, SkeletonParts } from './character-parts.ts';
import type { DiagnosticLog } from './diagnostics.ts';
import { defaultLimits, type Limits } from './limits.ts';
import { dofSize, noParent, type Skeleton } from './skeleton.ts';

const effect = 'the skeleton is not used';

/**
 * Checks the hierarchy, sorts the joints depth first (children in file order) and packs them.
 * Returns nothing, and reports why, if there are too many joints, a missing parent, no root, or a
 * cycle.
 */
export function buildSkeleton(
  parts: SkeletonParts,
  log: DiagnosticLog,
  limits: Limits = defaultLimits,
): Skeleton | undefined {
  const { joints } = parts;
  if (joints.length > limits.jointCount) {
    log.error({
      code: 'character/limit',
      expected: `at most ${limits.jointCount} joints`,
      found: `${joints.length} joints`,
      effect,
    });
    return undefined;
  }
  if (!parentsExist(joints, log) || !rootExists(joints, log)) return undefined;
  const order = depthFirstOrder(joints);
  if (order.length < joints.length) {
    reportCycle(joints, order, log);
    return undefined;
  }
  return pack(joints, order);
}

export const emptySkeleton: Skeleton = pack([], []);

function parentsExist(joints: readonly JointParts[], log: DiagnosticLog): boolean {
  for (const joint of joints) {
    if (Number.isInteger(joint.parent) && joint.parent >= -1 && joint.parent < joints.length) {
      continue;
    }
    log.error({
      code: 'character/parent',
      ...joint.place,
      expected: `a parent from -1 to ${joints.length - 1}`,
      found: `${joint.parent}`,
      effect,
    });
  }
  return !log.failed;
}

function rootExists(joints: readonly JointParts[], log: DiagnosticLog): boolean {
  if (joints.length === 0 || joints.some(({ parent }) => parent === noParent)) return true;
  const expected = 'at least one root (parent -1)';
  const found = `none among ${joints.length}`;
  log.error({ code: 'character/root', expected, found, effect });
  return false;
}

/**
 * File indices of all joints that can be reached from a root, parents first, each subtree
 * contiguous.
 */
function depthFirstOrder(joints: readonly JointParts[]): number[] {
  const children: number[][] = joints.map(() => []);
  const roots: number[] = [];
  joints.forEach(({ parent }, index) => {
    (parent === noParent ? roots : children[parent]!).push(index);
  });
  const order: number[] = [];
  const pending = roots.reverse();
  for (let joint = pending.pop(); joint !== undefined; joint = pending.pop()) {
    order.push(joint);
    pending.push(...children[joint]!.reverse());
  }
  return order;
}

function reportCycle(joints: readonly JointParts[], order: number[], log: DiagnosticLog): void {
  const reached = new Set(order);
  const start = joints.findIndex((_, index) => !reached.has(index));
  const path: number[] = [];
  const seen = new Set<number>();
  for (let joint = start; !seen.has(joint); joint = joints[joint]!.parent) {
    seen.add(joint);
    path.push(joint);
  }
  const entry = joints[path.at(-1)!]!.parent;
  const cycle = [...path.slice(path.indexOf(entry)), entry];
  const shown = cycle.length > 8 ? [...cycle.slice(0, 8), '…'] : cycle;
  log.error({
    code: 'character/cycle',
    ...joints[entry]!.place,
    expected: 'parents that lead to a root (-1)',
    found: shown.join(' > '),
    effect,
  });
}

function pack(joints: readonly JointParts[], order: readonly number[]): Skeleton {
  const jointCount = order.length;
  const sorted = order.map((index) => joints[index]!);
  const dofs = sorted.flatMap((joint) => joint.dofs);
  const qCount = dofs.reduce((sum, dof) => sum + dofSize[dof.kind], 0);
  const jointOfSource = new Uint16Array(jointCount);
  order.forEach((source, joint) => (jointOfSource[source] = joint));
  const parents = Int16Array.from(sorted, ({ parent }) =>
    parent === noParent ? noParent : jointOfSource[parent]!,
  );
  const depths = new Uint16Array(jointCount);
  parents.forEach((parent, joint) => {
    depths[joint] = parent === noParent ? 0 : depths[parent]! + 1;
  });

  const dofStart = new Uint16Array(jointCount + 1);
  sorted.forEach((joint, index) => {
    dofStart[index + 1] = dofStart[index]! + joint.dofs.length;
  });
  const dofQ = new Uint32Array(dofs.length);
  const qRest = new Float64Array(qCount);
  const qMin = new Float64Array(qCount).fill(-Infinity);
  const qMax = new Float64Array(qCount).fill(Infinity);
  let next = 0;
  dofs.forEach((dof, index) => {
    dofQ[index] = next;
    const size = dofSize[dof.kind];
    const identity = size === 4 ? [0, 0, 0, 1] : [0];
    qRest.set(dof.rest ?? identity, next);
    if (dof.limits && size === 1) {
      [qMin[next], qMax[next]] = dof.limits;
      qRest[next] = Math.min(Math.max(qRest[next]!, qMin[next]!), qMax[next]!);
    }
    next += size;
  });

  return {
    jointCount,
    names: sorted.map(({ name }) => name),
    ...(sorted.some(({ englishName }) => englishName) && {
      englishNames: sorted.map(({ englishName = '' }) => englishName),
    }),
    fileNames: sorted.map(({ fileName }) => fileName ?? ''),
    sourceIndex: Uint16Array.from(order),
    jointOfSource,
    parents,
    depths,
    restOffsets: Float64Array.from(sorted.flatMap(({ restOffset }) => restOffset)),
    restRotations: Float64Array.from(
      sorted.flatMap(({ restRotation }) => restRotation ?? [0, 0, 0, 1]),
    ),
    dofStart,
    dofKind: Uint8Array.from(dofs, ({ kind }) => kind),
    dofAxis: Float64Array.from(dofs.flatMap(({ axis }) => axis)),
    dofQ,
    qRest,
    qMin,
    qMax,
    displayBoxes: packBoxes(sorted),
  };
}

/** If only some joints have a box, the others get an empty one. */
function packBoxes(joints: readonly JointParts[]): Float32Array | null {
  if (joints.every(({ displayBox }) => displayBox === undefined)) return null;
  const boxes = new Float32Array(joints.length * 6);
  joints.forEach(({ displayBox }, joint) => boxes.set(displayBox ?? [], joint * 6));
  return boxes;
}
