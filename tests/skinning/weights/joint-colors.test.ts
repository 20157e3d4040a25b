import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { jointColors } from '../../../src/skinning/weights/joint-colors.ts';
import { rowSum, vertexColors, weightOf } from '../../../src/skinning/weights/views.ts';
import { bundledIds, readBundled } from '../../support/bundled.ts';
import { leastDifference, readRight, type Tree } from '../../support/color-judges.ts';

it.each(bundledIds)(
  'of %s, joints beside each other differ by 10 to all eyes, and 18 of 20 vertices are read right',
  async (id) => {
    const character = await readBundled(id);
    expect(leastDifference(character.skeleton)).toBeGreaterThanOrEqual(10);
    expect(Math.min(...readRight(character)!)).toBeGreaterThanOrEqual(18);
  },
);

describe('the colors of joints', () => {
  /** Any tree in which no joint has more than five children. */
  const trees = fc.array(fc.nat(1000), { minLength: 1, maxLength: 120 }).map((choices): Tree => {
    const parents = [-1];
    const children = [0];
    for (const choice of choices) {
      const open = parents.flatMap((_, joint) => (children[joint]! < 5 ? [joint] : []));
      const parent = open[choice % open.length]!;
      children[parent]!++;
      parents.push(parent);
      children.push(0);
    }
    return { jointCount: parents.length, parents: Int16Array.from(parents) };
  });

  it('differ by 8 between neighbors in every tree with at most five children a joint', () => {
    fc.assert(
      fc.property(trees, (tree) => {
        expect(leastDifference(tree)).toBeGreaterThanOrEqual(8);
      }),
      { numRuns: 40 },
    );
  });

  it('have a hue each, and are the same for the same tree', () => {
    for (const jointCount of [1, 36, 37, 1000]) {
      const parents = Int16Array.from({ length: jointCount }, (_, joint) =>
        joint === 0 ? -1 : Math.floor((joint - 1) / 3),
      );
      const { hues, bytes } = jointColors({ jointCount, parents });
      expect(new Set(hues).size).toBe(jointCount);
      expect(jointColors({ jointCount, parents }).bytes).toEqual(bytes);
    }
  });
});

describe('the color of a vertex', () => {
  it('is the mean of the colors of its joints by weight', async () => {
    const { skeleton, skin, mesh } = await readBundled('dog');
    const colors = jointColors(skeleton);
    const subject = { skin, colors, joint: null, errors: null, largestError: 0 };
    const shown = vertexColors('joints', subject, mesh.pointOf);
    for (let vertex = 0; vertex < mesh.vertexCount; vertex += 101) {
      const point = mesh.pointOf[vertex]!;
      const sum = rowSum(skin, point);
      for (let channel = 0; channel < 3; channel++) {
        let mean = 0;
        for (let joint = 0; joint < skeleton.jointCount; joint++) {
          mean += (weightOf(skin, point, joint) / sum) * colors.bytes[joint * 3 + channel]!;
        }
        expect(Math.abs(shown[vertex * 4 + channel]! - mean)).toBeLessThanOrEqual(0.500001);
      }
      expect(shown[vertex * 4 + 3]).toBe(255);
    }
  });
});
