import type { Character } from '../../src/core/character.ts';
import { colorDifference, type Lab, labOf } from '../../src/core/color-difference.ts';
import type { Skeleton } from '../../src/core/skeleton.ts';
import { influencesOf, noJoint, type Skin } from '../../src/core/skin.ts';
import { jointColors } from '../../src/skinning/weights/joint-colors.ts';
import { vertexColors, weightOf } from '../../src/skinning/weights/views.ts';
import { randomSource } from './random.ts';

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
/** Eyes of each kind, by the names of the table. */
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

export type Tree = Pick<Skeleton, 'jointCount' | 'parents'>;

/** Parent and child, and siblings. */
function areNeighbors({ parents }: Tree, a: number, b: number): boolean {
  return parents[a] === b || parents[b] === a || parents[a] === parents[b];
}

/** The least difference of two neighbors to the eyes that see them as most alike. */
export function leastDifference(tree: Tree): number {
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

/**
 * How many of 20 vertices, at most, show to each kind of eyes a color that is nearest to that of the
 * joint that owns them; null if no joints own so many.
 */
export function readRight(character: Character): readonly number[] | null {
  const { skeleton, skin, mesh } = character;
  const owned = ownedVertices(skin);
  if (owned.length < 20) return null;
  const colors = jointColors(skeleton);
  const subject = { skin, colors, joint: null, errors: null, largestError: 0 };
  const shown = vertexColors('joints', subject, mesh.pointOf);
  return eyes.map((eye) => {
    const random = randomSource(7);
    let right = 0;
    for (let count = 0; count < 20; count++) {
      const { point, owner } = owned[Math.floor(random() * owned.length)]!;
      const lab = seen(shown.subarray(point * 4, point * 4 + 3), eye);
      const near = withinTwoEdges(skeleton, owner);
      const differences = near.map((joint) =>
        colorDifference(lab, seen(colors.bytes.subarray(joint * 3, joint * 3 + 3), eye)),
      );
      if (near[differences.indexOf(Math.min(...differences))] === owner) right++;
    }
    return right;
  });
}

/** The vertices of which one joint has at least nine tenths. */
function ownedVertices(skin: Skin) {
  return Array.from({ length: skin.start.length - 1 }, (_, point) => {
    const joints = influencesOf(skin, point).map(({ entry }) => skin.paletteJoint[entry]!);
    const owner = joints.find((joint) => joint !== noJoint && weightOf(skin, point, joint) >= 0.9);
    return owner === undefined ? [] : [{ point, owner }];
  }).flat();
}

function withinTwoEdges({ jointCount, parents }: Tree, from: number): number[] {
  const joints = Array.from({ length: jointCount }, (_, joint) => joint);
  const next = (joint: number): number[] =>
    joints.filter((other) => parents[other] === joint || parents[joint] === other);
  return [...new Set([from, ...next(from), ...next(from).flatMap(next)])];
}
