import { describe, expect, it } from 'vitest';
import { diagonal } from '../../src/core/bounds.ts';
import { createActor } from '../../src/document/scene.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { truncationOf } from '../../src/evaluation/truncation.ts';
import { characterOfRig, qOfValues } from '../fixtures/character-of-rig.ts';
import { type Rig, transformsOf } from '../fixtures/rig.ts';
import { randomValues, rotatedTree } from '../fixtures/rigs.ts';
import { type Influence } from '../reference/skinned-vertex.ts';
import { methodOracles } from '../reference/skinning.ts';
import type { Values } from '../reference/kinematics.ts';
import { tolerances } from '../tolerances.ts';

const oracle = methodOracles['linear-blend']!;

/** The strongest influences with the sum of all, in float64 and written apart from the product. */
function strongest(row: readonly Influence[], count: number): Influence[] {
  const kept = [...row].sort(([, a], [, b]) => Math.abs(b) - Math.abs(a)).slice(0, count);
  const total = (influences: readonly Influence[]): number =>
    influences.reduce((sum, [, weight]) => sum + weight, 0);
  return kept.map(([joint, weight]) => [joint, (weight * total(row)) / total(kept)]);
}

function expectedErrors(rig: Rig, values: Values, count: number): number[] {
  const transforms = transformsOf(rig, values);
  return rig.points.map((position, point) => {
    const at = (influences: readonly Influence[]): readonly number[] =>
      oracle.position({ position, normal: [0, 1, 0], influences }, transforms);
    const row = rig.rows[point]!;
    const [full, kept] = [at(row), at(strongest(row, count))];
    return Math.hypot(...full.map((value, axis) => value - kept[axis]!));
  });
}

describe('keeping few influences', () => {
  const rig = rotatedTree();
  const character = characterOfRig(rig);
  const values = randomValues(rig, 51);
  const q = qOfValues(character.skeleton, values);
  const bound = 2 * tolerances.skinning * diagonal(character.bounds);

  it.each([1, 2, 4])('to %i moves each point as far as the formula says', (influences) => {
    const actor = createActor(1, character, 'linear-blend', { q, influences });
    const found = truncationOf(new Evaluator(actor).evaluate(actor, 0))!;
    const expected = expectedErrors(rig, values, influences);
    expected.forEach((error, point) => {
      expect(Math.abs(found.errors[point]! - error), `point ${point}`).toBeLessThan(bound);
    });
    expect(found.largest).toBeCloseTo(Math.max(...expected), 5);
    expect(expected[found.worst]).toBeCloseTo(Math.max(...expected), 5);
    expect(found.mean).toBeCloseTo(expected.reduce((a, b) => a + b) / expected.length, 5);
    expect(found.movedCount).toBe(expected.filter((error) => error > bound).length);
    expect(found.largest, 'the pose shows a difference').toBeGreaterThan(100 * bound);
    expect(found.height).toBe(character.bounds.max[1]! - character.bounds.min[1]!);
  });

  it('moves nothing at rest, nor where each point has no more', () => {
    for (const kept of [{ influences: 2 }, { q, influences: 64 }]) {
      const actor = createActor(1, character, 'linear-blend', kept);
      const found = truncationOf(new Evaluator(actor).evaluate(actor, 0))!;
      expect(found).toMatchObject({ movedCount: 0, largest: 0, mean: 0 });
    }
  });

  it('is measured anew in another pose, and not at all if all are kept', () => {
    const resting = createActor(1, character, 'linear-blend', { influences: 1 });
    const evaluator = new Evaluator(resting);
    expect(truncationOf(evaluator.evaluate(resting, 0))!.largest).toBe(0);
    const posed = { ...resting, q };
    expect(truncationOf(evaluator.evaluate(posed, 0))!.largest).toBeGreaterThan(0);
    expect(truncationOf(evaluator.evaluate({ ...posed, influences: null }, 0))).toBeNull();
  });
});
