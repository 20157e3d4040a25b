import { describe, expect, it } from 'vitest';
import { normalizeSkin } from '../../src/core/skin.ts';
import { linearBlend } from '../../src/skinning/linear-blend.ts';
import { loadedKernels } from '../support/kernels.ts';
import { skinVertices } from '../support/skin-vertices.ts';
import { characterOfRig, qOfValues } from '../fixtures/character-of-rig.ts';
import { transformsOf } from '../fixtures/rig.ts';
import { oddWeights, randomValues } from '../fixtures/rigs.ts';
import { transform } from '../reference/matrix.ts';
import { skinningMatrix } from '../reference/skinned-vertex.ts';
import { boundingDiagonal, largestDifference, numbersAt } from '../support/compare.ts';
import { tolerances } from '../tolerances.ts';

const rig = oddWeights();
const values = randomValues(rig, 41);
const transforms = transformsOf(rig, values);
const bound = tolerances.skinning * boundingDiagonal(rig.points);
const character = characterOfRig(rig);
const pose = { q: qOfValues(character.skeleton, values) };

describe('points without weights', () => {
  const alone = loadedKernels.filter((method) => !('finish' in method));
  it.each(alone)('follow the first root rigidly under $id', (method) => {
    const { positions } = skinVertices(character, character.skin, pose, method);
    const matrix = skinningMatrix(transforms.firstRoot, transforms);
    rig.points.forEach((point, index) => {
      if (rig.rows[index]!.length > 0) return;
      const expected = transform(matrix, point);
      expect(largestDifference(numbersAt(positions, index, 3), expected)).toBeLessThan(bound);
    });
  });
});

describe('rows that do not sum to one', () => {
  it('are blended unchanged, and differently if normalized', () => {
    const raw = skinVertices(character, character.skin, pose, linearBlend).positions;
    const skin = normalizeSkin(character.skin);
    const normalized = skinVertices(character, skin, pose, linearBlend).positions;
    rig.rows.forEach((row, point) => {
      const sum = row.reduce((total, [, weight]) => total + weight, 0);
      if (row.length === 0) return;
      // p′ = Σ w·M·p is linear in the weights, so normalizing divides the point itself.
      const divided = numbersAt(raw, point, 3).map((value) => value / sum);
      const difference = largestDifference(divided, numbersAt(normalized, point, 3));
      expect(difference).toBeLessThan((4 * bound) / Math.min(1, Math.abs(sum)));
    });
    expect(largestDifference(raw, normalized)).toBeGreaterThan(0.1);
  });
});
