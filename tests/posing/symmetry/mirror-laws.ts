import { vec3 } from 'gl-matrix';
import type { Character } from '../../../src/core/character.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { DofKind, type Skeleton } from '../../../src/core/skeleton.ts';
import type { Symmetry } from '../../../src/posing/symmetry/symmetry.ts';
import { linearBlend } from '../../../src/skinning/linear-blend.ts';
import { readBundled } from '../../support/bundled.ts';
import { randomBetween, randomRotation, randomSource } from '../../support/random.ts';
import { skinVertices } from '../../support/skin-vertices.ts';

const read = new Map<string, Promise<Character>>();

/** A bundled character, read once for all tests of a file. */
export function bundled(id: string): Promise<Character> {
  let found = read.get(id);
  if (!found) read.set(id, (found = readBundled(id)));
  return found;
}

/** A pose within the limits, with angles up to `angle` and slides up to a tenth of it. */
export function randomPose(skeleton: Skeleton, seed: number, angle = 1): Float64Array {
  const { dofKind, dofQ, qRest, qMin, qMax } = skeleton;
  const random = randomSource(seed);
  const q = qRest.slice();
  dofKind.forEach((kind, dof) => {
    const at = dofQ[dof]!;
    if (kind === DofKind.ball) {
      q.set(
        randomRotation(random, angle).map((value) => value + 0),
        at,
      );
      return;
    }
    const reach = kind === DofKind.slide ? angle / 10 : angle;
    const value = q[at]! + randomBetween(random, -reach, reach);
    // Plus zero, since a pose has no negative zeros.
    q[at] = Math.min(Math.max(value, qMin[at]!), qMax[at]!) + 0;
  });
  return q;
}

/** The posed points of a character. */
export function posedPoints(character: Character, q: Float64Array): Float32Array {
  return skinVertices(character, character.skin, { q }, linearBlend).positions;
}

/** For each point of a mesh its mirror image, or -1 where it has none within a distance. */
export function mirroredPoints(
  positions: ArrayLike<number>,
  plane: number,
  within: number,
): Int32Array {
  const count = positions.length / 3;
  const cellOf = (x: number, y: number, z: number): string =>
    [x, y, z].map((value) => Math.floor(value / within)).join();
  const cells = new Map<string, number[]>();
  const place = (i: number): [number, number, number] => [
    positions[i * 3]!,
    positions[i * 3 + 1]!,
    positions[i * 3 + 2]!,
  ];
  for (let i = 0; i < count; i++) {
    const key = cellOf(...place(i));
    cells.set(key, [...(cells.get(key) ?? []), i]);
  }
  return Int32Array.from({ length: count }, (_, i) => {
    const [x, y, z] = place(i);
    const image = [2 * plane - x, y, z] as const;
    let best = -1;
    let nearest = within;
    for (const dx of [-within, 0, within]) {
      for (const dy of [-within, 0, within]) {
        for (const dz of [-within, 0, within]) {
          for (const each of cells.get(cellOf(image[0] + dx, image[1] + dy, image[2] + dz)) ?? []) {
            const distance = vec3.distance(place(each), image);
            if (distance <= nearest) [best, nearest] = [each, distance];
          }
        }
      }
    }
    return best;
  });
}

/** The largest distance of a joint of a pose from the mirror image of its partner in another one. */
export function largestPairOffset(
  { skeleton, partners, plane }: Symmetry,
  q: Float64Array,
  image: Float64Array,
  joints: readonly number[],
): number {
  const [posed, other] = [q, image].map((each) => jointMatrices(skeleton, each));
  const place = (matrices: Float64Array, joint: number) =>
    matrices.subarray(joint * 16 + 12, joint * 16 + 15);
  const offsets = joints.map((joint) => {
    const [x, y, z] = place(posed!, joint);
    return vec3.distance([2 * plane - x!, y!, z!], [...place(other!, partners[joint]!)] as vec3);
  });
  return Math.max(...offsets);
}
