import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Character } from '../../../src/core/character.ts';
import { colorDifference, type Lab, labOf } from '../../../src/core/color-difference.ts';
import type { Skeleton } from '../../../src/core/skeleton.ts';
import { jointColors } from '../../../src/skinning/weights/joint-colors.ts';
import { rowSum, vertexColors, weightOf } from '../../../src/skinning/weights/views.ts';
import { bundledIds, readBundled } from '../../support/bundled.ts';
import { randomSource } from '../../support/random.ts';

// What is asked of the colors, with the table of Machado, Oliveira and Fernandes (2009) written
// apart from the code that chooses them.
const table: Readonly<Record<string, readonly number[]>> = {
  'full color vision': [1, 0, 0, 0, 1, 0, 0, 0, 1],
  protanopia: [
    0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998,
  ],
  deuteranopia: [
    0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.01182, 0.04294, 0.968881,
  ],
  tritanopia: [
    1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.3039,
  ],
};
const eyes = Object.keys(table);

function seen(rgb: ArrayLike<number>, eye: string): Lab {
  const light = [0, 1, 2].map((i) => {
    const encoded = rgb[i]! / 255;
    return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
  });
  const [r, g, b] = [0, 3, 6].map((row) => {
    const sum = light.reduce((total, each, i) => total + table[eye]![row + i]! * each, 0);
    const within = Math.min(1, Math.max(0, sum));
    return 255 * (within <= 0.0031308 ? 12.92 * within : 1.055 * within ** (1 / 2.4) - 0.055);
  });
  return labOf([r!, g!, b!]);
}

type Tree = Pick<Skeleton, 'jointCount' | 'parents'>;

/** Parent and child, and siblings. */
function areNeighbors({ parents }: Tree, a: number, b: number): boolean {
  return parents[a] === b || parents[b] === a || parents[a] === parents[b];
}

/** The least difference of two neighbors to the eyes that see them as most alike. */
function leastDifference(tree: Tree): number {
  const { bytes } = jointColors(tree);
  let least = Infinity;
  for (const eye of eyes) {
    const labs = Array.from({ length: tree.jointCount }, (_, joint) =>
      seen(bytes.subarray(joint * 3, joint * 3 + 3), eye),
    );
    labs.forEach((lab, a) => {
      for (let b = 0; b < a; b++) {
        if (areNeighbors(tree, a, b)) least = Math.min(least, colorDifference(lab, labs[b]!));
      }
    });
  }
  return least;
}

it.each(bundledIds)(
  'of %s, joints beside each other differ by 10 to all eyes, and 18 of 20 vertices are read right',
  async (id) => {
    const character = await readBundled(id);
    expect(leastDifference(character.skeleton)).toBeGreaterThanOrEqual(10);
    for (const eye of eyes) expect(readRight(character, eye), eye).toBeGreaterThanOrEqual(18);
  },
);

/** How many of 20 vertices show a color that is nearest to that of the joint that owns them. */
function readRight({ skeleton, skin, mesh }: Character, eye: string): number {
  const colors = jointColors(skeleton);
  const subject = { skin, colors, joint: null, errors: null, largestError: 0 };
  const shown = vertexColors('joints', subject, mesh.pointOf);
  const swatches = Array.from({ length: skeleton.jointCount }, (_, joint) =>
    seen(colors.bytes.subarray(joint * 3, joint * 3 + 3), eye),
  );
  const owned = Array.from({ length: mesh.pointCount }, (_, point) => {
    const joints = Array.from({ length: skeleton.jointCount }, (_, joint) => joint);
    const owner = joints.find((joint) => weightOf(skin, point, joint) >= 0.9);
    return owner === undefined ? [] : [{ point, owner }];
  }).flat();
  expect(owned.length).toBeGreaterThanOrEqual(20);
  const random = randomSource(7);
  let right = 0;
  for (let count = 0; count < 20; count++) {
    const { point, owner } = owned[Math.floor(random() * owned.length)]!;
    const lab = seen(shown.subarray(point * 4, point * 4 + 3), eye);
    const near = withinTwoEdges(skeleton, owner);
    const differences = near.map((joint) => colorDifference(lab, swatches[joint]!));
    if (near[differences.indexOf(Math.min(...differences))] === owner) right++;
  }
  return right;
}

function withinTwoEdges({ jointCount, parents }: Tree, from: number): number[] {
  const joints = Array.from({ length: jointCount }, (_, joint) => joint);
  const next = (joint: number): number[] =>
    joints.filter((other) => parents[other] === joint || parents[joint] === other);
  return [...new Set([from, ...next(from), ...next(from).flatMap(next)])];
}

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
