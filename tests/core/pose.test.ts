import { describe, expect, it } from 'vitest';
import { emptySkeleton } from '../../src/core/build-skeleton.ts';
import { axisDofs, jointRange, restPose } from '../../src/core/pose.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { firstRoot } from '../../src/core/subtree.ts';
import { buildStaticSkin } from '../../src/core/build-skin.ts';
import { largestBindError } from '../../src/skinning/bind-error.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';

const { skeleton } = characterOfRig(rotatedTree());

function jointOf(source: number): number {
  return skeleton.jointOfSource[source]!;
}

describe('restPose', () => {
  it('is a copy of the pose of the file', () => {
    const pose = restPose(skeleton);
    expect(pose.q).toEqual(skeleton.qRest);
    pose.q.fill(9);
    expect(restPose(skeleton).q).toEqual(skeleton.qRest);
  });
});

describe('axisDofs', () => {
  it("are a joint's slides and hinges along x, y, z, in stored order", () => {
    const shown = (source: number) =>
      axisDofs(skeleton, jointOf(source)).map(({ kind, axis }) => [kind, axis]);
    const { slide, hinge } = DofKind;
    expect(shown(0)).toEqual([
      [hinge, 0],
      [hinge, 1],
      [hinge, 2],
    ]);
    expect(shown(2)).toEqual([
      [hinge, 2],
      [hinge, 1],
      [hinge, 0],
    ]);
    // A slider can't show balls and oblique axes as one number.
    expect(shown(1)).toEqual([]);
    expect(shown(3)).toEqual([]);
    expect(shown(4)).toEqual([[slide, 1]]);
    expect(shown(8)).toEqual([
      [slide, 0],
      [slide, 1],
      [slide, 2],
      [hinge, 0],
      [hinge, 1],
      [hinge, 2],
    ]);
  });

  it('have their index in q', () => {
    const q = skeleton.qRest.map((_, index) => index);
    for (let joint = 0; joint < skeleton.jointCount; joint++) {
      const [start, end] = jointRange(skeleton, joint);
      for (const { dof, index } of axisDofs(skeleton, joint)) {
        expect(index).toBe(skeleton.dofQ[dof]);
        expect([...q.subarray(start, end)]).toContain(index);
      }
    }
  });
});

describe('jointRange', () => {
  it('takes up all of q, joint after joint', () => {
    const sizes = [3, 4, 3, 1, 5, 3, 0, 1, 6];
    let next = 0;
    skeleton.sourceIndex.forEach((source, joint) => {
      expect(jointRange(skeleton, joint)).toEqual([next, next + sizes[source]!]);
      next += sizes[source]!;
    });
    expect(next).toBe(skeleton.qRest.length);
  });
});

describe('without joints', () => {
  it('there is no root, no value and no bind error', () => {
    expect(firstRoot(emptySkeleton)).toBe(-1);
    expect(restPose(emptySkeleton).q).toHaveLength(0);
    expect(largestBindError(emptySkeleton, buildStaticSkin(2))).toBe(0);
  });
});
