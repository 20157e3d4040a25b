import { describe, expect, it } from 'vitest';
import { createActor } from '../../../src/document/scene.ts';
import type { MethodId, MethodSettings } from '../../../src/skinning/method.ts';
import { Evaluator } from '../../../src/evaluation/evaluator.ts';
import type { Explanation } from '../../../src/evaluation/explain/explanation.ts';
import { explainers } from '../../../src/evaluation/explain/registry.ts';
import { methods } from '../../../src/skinning/registry.ts';
import { characterOfRig, qOfValues } from '../../fixtures/character-of-rig.ts';
import type { Rig } from '../../fixtures/rig.ts';
import { randomValues, soundRigs } from '../../fixtures/rigs.ts';
import { boundingDiagonal, largestDifference, numbersAt } from '../../support/compare.ts';
import { allThere, fullPool } from '../../support/kernels.ts';
import { tolerances } from '../../tolerances.ts';

/** A rig in a random pose, by a method. */
async function evaluationOf(rig: Rig, method: MethodId, settings: MethodSettings = {}) {
  const character = characterOfRig(rig);
  const actor = createActor(1, character, method, {
    q: qOfValues(character.skeleton, randomValues(rig, 71)),
    methodSettings: settings,
  });
  await allThere.loadFor(actor);
  return new Evaluator(actor, fullPool());
}

function sumOfRows(rows: readonly { readonly values: readonly number[] }[]): number[] {
  return rows[0]!.values.map((_, i) => rows.reduce((sum, { values }) => sum + values[i]!, 0));
}

function stepOf({ steps }: Explanation, title: RegExp) {
  return steps.find((step) => title.test(step.title))!;
}

describe.each(methods.map(({ id }) => id))('what is shown of %s', (id) => {
  it.each(Object.entries(soundRigs))('sums to every vertex of "%s"', async (_, makeRig) => {
    const rig = makeRig();
    const evaluation = await evaluationOf(rig, id);
    expect(evaluation.method.id).toBe(id);
    const { positions } = evaluation.vertices();
    const bound = tolerances.skinning * boundingDiagonal(rig.points);
    for (let point = 0; point < rig.points.length; point++) {
      const explained = explainers[id](evaluation, point);
      const last = explained.steps.at(-1)!;
      const vertex = numbersAt(positions, point, 3);
      expect(largestDifference(sumOfRows(last.rows), vertex)).toBeLessThan(bound);
      expect(largestDifference(explained.place, vertex)).toBeLessThan(bound);
      for (const { rows, total } of explained.steps) {
        if (total) expect(largestDifference(sumOfRows(rows), total)).toBeLessThan(1e-9);
      }
    }
    evaluation.dispose();
  });
});

it('linear blend adds each ghost times its weight', async () => {
  const evaluation = await evaluationOf(soundRigs['many influences']!(), 'linear-blend');
  const { ghosts, steps } = explainers['linear-blend'](evaluation, 3);
  expect(ghosts.length).toBeGreaterThan(10);
  steps.at(-1)!.rows.forEach(({ of, values }, i) => {
    const { entry, weight, place } = ghosts[i]!;
    expect(of).toBe(entry);
    expect(
      largestDifference(
        values,
        place.map((value) => weight * value),
      ),
    ).toBeLessThan(1e-12);
  });
});

it('the sum of dual quaternions is the motion that takes the point to its place', async () => {
  const evaluation = await evaluationOf(soundRigs['rotated tree']!(), 'dual-quaternion');
  for (let point = 0; point < evaluation.rest.pointCount; point++) {
    const explained = explainers['dual-quaternion'](evaluation, point);
    const [x, y, z, w] = stepOf(explained, /rotations/).total!;
    const dual = stepOf(explained, /dual parts/).total!;
    // The quaternion product q̂ (1 + ε p) q̂*, divided by the squared length of the sum.
    const q = [x!, y!, z!, w!];
    const conjugate = [-x!, -y!, -z!, w!];
    const turned = product(product(q, [...explained.rest, 0]), conjugate);
    const moved = product(dual, conjugate);
    const squared = q.reduce((sum, each) => sum + each * each, 0);
    const place = [0, 1, 2].map((i) => (turned[i]! + 2 * moved[i]!) / squared);
    expect(largestDifference(place, explained.place)).toBeLessThan(1e-9);
  }
});

function product(a: readonly number[], b: readonly number[]): number[] {
  const [ax, ay, az, aw] = [a[0]!, a[1]!, a[2]!, a[3]!];
  const [bx, by, bz, bw] = [b[0]!, b[1]!, b[2]!, b[3]!];
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

it('a blend of linear blend and dual quaternions shows the shares of both', async () => {
  const blend = 0.3;
  const rig = soundRigs['rotated tree']!();
  const whole = await evaluationOf(rig, 'dual-quaternion', { blend });
  const linear = await evaluationOf(rig, 'linear-blend');
  const explained = explainers['dual-quaternion'](whole, 2);
  const expected = explainers['linear-blend'](linear, 2).place.map((value) => value * (1 - blend));
  const row = explained.steps.at(-1)!.rows.find(({ of }) => of === 'linear blend')!;
  expect(largestDifference(row.values, expected)).toBeLessThan(1e-12);
  const vertex = numbersAt(whole.vertices().positions, 2, 3);
  const bound = tolerances.skinning * boundingDiagonal(rig.points);
  expect(largestDifference(explained.place, vertex)).toBeLessThan(bound);
});
