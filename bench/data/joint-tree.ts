import { buildCharacter } from '../../src/core/build-character.ts';
import { DofKind, type Skeleton } from '../../src/core/skeleton.ts';
import { randomBetween, randomSource } from '../../tests/support/random.ts';

/** Chains of this many joints hang on the first joint, as limbs do. */
const chainLength = 25;

/** A tree of joints with three hinges each, X, Y and Z, in depth-first order. */
export interface JointTree {
  readonly skeleton: Skeleton;
  readonly parents: readonly number[];
  /** (jointCount × 3) in the parent's frame. */
  readonly offsets: Float64Array;
}

export function jointTree(jointCount: number): JointTree {
  const random = randomSource(jointCount);
  const parents = Array.from({ length: jointCount }, (_, joint) => {
    if (joint === 0) return -1;
    return (joint - 1) % chainLength === 0 ? 0 : joint - 1;
  });
  const offsets = Float64Array.from({ length: jointCount * 3 }, () =>
    randomBetween(random, -0.1, 0.1),
  );
  const { value } = buildCharacter({
    name: 'tree',
    missing: [],
    skeleton: {
      file: 'tree.skel',
      joints: parents.map((parent, joint) => ({
        name: `joint ${joint}`,
        parent,
        restOffset: [0, 1, 2].map((axis) => offsets[joint * 3 + axis]!) as [number, number, number],
        dofs: [0, 1, 2].map((axis) => ({
          kind: DofKind.hinge,
          axis: [0, 1, 2].map((i) => (i === axis ? 1 : 0)) as [number, number, number],
        })),
      })),
    },
  });
  if (!value) throw new Error('the tree can be built');
  return { skeleton: value.skeleton, parents, offsets };
}

/** (jointCount × 3) angles in radians, which differ in every pose. */
export function treeAngles(jointCount: number, pose: number): Float64Array {
  return Float64Array.from({ length: jointCount * 3 }, (_, i) => Math.sin(i + 0.3 * pose));
}
