import type { Character } from '../../core/character.ts';
import { assert } from '../../core/assert.ts';
import { largestInfluenceCount, noJoint } from '../../core/skin.ts';
import { mmdShape } from './shape.ts';

/** The weights of a file, which are hundredths of two bones. */
export interface BonePairs {
  /** (vertexCount × 2) file indices, the heavier bone first; twice the same for one bone. */
  readonly bones: Uint16Array;
  /** (vertexCount) hundredths of the first bone. */
  readonly weights: Uint8Array;
  /** The number of points whose weights changed, and the largest change of one weight. */
  readonly changedCount: number;
  readonly largestChange: number;
}

/** A smaller change is only the rounding of a float32. */
const smallestChange = 1e-6;

/**
 * Rounds the weights of each point, of which there are at most two, to hundredths that sum to one. A
 * negative weight becomes 0. A mesh without weights follows the first bone.
 */
export function bonePairs({ mesh, skin, skeleton }: Character): BonePairs {
  assert(largestInfluenceCount(skin) <= mmdShape.influences, 'at most two influences a vertex');
  const bones = new Uint16Array(mesh.vertexCount * 2);
  const weights = new Uint8Array(mesh.vertexCount).fill(100);
  if (skin.paletteJoint.includes(noJoint)) {
    return { bones, weights, changedCount: 0, largestChange: 0 };
  }
  let changedCount = 0;
  let largestChange = 0;
  mesh.pointOf.forEach((point, vertex) => {
    const [heavy, light] = heavierFirst(skin.start[point]!, skin.start[point + 1]!);
    const hundredths = hundredthsOf(weightOf(heavy), weightOf(light));
    bones[vertex * 2] = boneOf(heavy);
    bones[vertex * 2 + 1] = boneOf(hundredths === 100 ? heavy : light);
    weights[vertex] = hundredths;
    if (vertex >= mesh.pointCount) return;
    const change = Math.max(
      Math.abs(weightOf(heavy) - hundredths / 100),
      Math.abs(weightOf(light) - (1 - hundredths / 100)),
    );
    if (change > smallestChange) changedCount++;
    largestChange = Math.max(largestChange, change);
  });
  return { bones, weights, changedCount, largestChange };

  /** The two influences of a row; -1 for a second one that is not there. */
  function heavierFirst(from: number, end: number): [number, number] {
    if (end - from < 2) return [from, -1];
    return weightOf(from) >= weightOf(from + 1) ? [from, from + 1] : [from + 1, from];
  }

  function weightOf(influence: number): number {
    return skin.weights[influence] ?? 0;
  }

  function boneOf(influence: number): number {
    return skeleton.sourceIndex[skin.paletteJoint[skin.entries[influence]!]!]!;
  }
}

function hundredthsOf(heavy: number, light: number): number {
  if (!(light > 0)) return 100;
  return Math.round((heavy / (heavy + light)) * 100);
}
