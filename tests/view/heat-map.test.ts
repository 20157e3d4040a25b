import { describe, expect, it } from 'vitest';
import { createActor } from '../../src/document/scene.ts';
import { differenceOf, sizeOf } from '../../src/evaluation/comparison/difference.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { Kernels } from '../../src/evaluation/kernels.ts';
import { EvaluationPool } from '../../src/evaluation/evaluation-pool.ts';
import { colorAt, errorRamp, zeroColor } from '../../src/skinning/weights/ramps.ts';
import { heatPaint } from '../../src/view/heat-map.ts';
import { characterOfRig, qOfValues } from '../fixtures/character-of-rig.ts';
import { randomValues, rotatedTree } from '../fixtures/rigs.ts';

describe('a heat map', () => {
  it('colors every character by its own distances as parts of its own height', async () => {
    const kernels = new Kernels();
    const pool = new EvaluationPool(kernels);
    await kernels.load('dual-quaternion');
    const rig = rotatedTree();
    const character = characterOfRig(rig);
    const { height } = sizeOf(character);
    const count = character.mesh.pointCount;
    const part = 0.3;
    const paint = heatPaint((id) => (id === 1 ? 'linear-blend' : 'dual-quaternion'), kernels, part);
    const shown = [1, 2].map((id) => {
      const q = qOfValues(character.skeleton, randomValues(rig, 17));
      const evaluate = (method: 'linear-blend' | 'dual-quaternion') => {
        const actor = createActor(id, character, method, { q });
        return new Evaluator(actor, pool).evaluate(actor, 0);
      };
      return { dual: evaluate('dual-quaternion'), linear: evaluate('linear-blend') };
    });
    const { distances, largest } = differenceOf(
      shown[0]!.dual.vertices().positions,
      shown[0]!.linear.vertices().positions,
      count,
    );
    expect(largest, 'something to show').toBeGreaterThan(0.01 * height);
    const colors = paint(shown[0]!.dual);
    distances.forEach((distance, point) => {
      if (distance < 1e-5 * height) return;
      const [red, green, blue] = colorAt(errorRamp, distance / (part * height));
      expect([...colors.subarray(4 * point, 4 * point + 3)]).toEqual([red, green, blue]);
    });
    expect(paint(shown[0]!.dual), 'the same array until the pose changes').toBe(colors);
    // The second character's base is its own method.
    const same = paint(shown[1]!.dual);
    for (let point = 0; point < count; point++) {
      expect([...same.subarray(4 * point, 4 * point + 3)]).toEqual([...zeroColor]);
    }
  });
});
