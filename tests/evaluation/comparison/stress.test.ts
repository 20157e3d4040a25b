import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Character } from '../../../src/core/character.ts';
import { jointRange } from '../../../src/core/pose.ts';
import { DofKind, type Skeleton } from '../../../src/core/skeleton.ts';
import { subtreeEnd } from '../../../src/core/subtree.ts';
import { createActor } from '../../../src/document/scene.ts';
import { compareWith } from '../../../src/evaluation/comparison/compare.ts';
import { deformingJoints } from '../../../src/evaluation/comparison/deforming-joints.ts';
import { sizeOf } from '../../../src/evaluation/comparison/difference.ts';
import { stressOf, worstFirst } from '../../../src/evaluation/comparison/stress.ts';
import { stressPoses } from '../../../src/evaluation/comparison/stress-poses.ts';
import { stressLabel, stressRows } from '../../../src/evaluation/comparison/stress-rows.ts';
import { Evaluator } from '../../../src/evaluation/evaluator.ts';
import type { MethodId } from '../../../src/skinning/method.ts';
import { characterOfRig } from '../../fixtures/character-of-rig.ts';
import { forest, rotatedTree } from '../../fixtures/rigs.ts';
import { twistingTube } from '../../fixtures/twisting-tube.ts';
import { readBundled } from '../../support/bundled.ts';
import { fullPool } from '../../support/kernels.ts';

const degree = Math.PI / 180;
const tube = await twistingTube();
const trees = [characterOfRig(rotatedTree()), characterOfRig(forest())];

/** The poses of a character from the file's pose. */
const posesOf = (character: Character, ...ranges: Parameters<typeof stressPoses>[3][]) =>
  stressPoses(character, character.skin, character.skeleton.qRest, ...ranges);
const labelsOf = (character: Character, ...ranges: Parameters<typeof stressPoses>[3][]) =>
  posesOf(character, ...ranges).map((pose) => stressLabel(character.skeleton, pose));

/** The hinges of a skeleton, as indices of q. */
function hingesOf({ dofKind, dofQ }: Skeleton): number[] {
  return [...dofQ].filter((_, dof) => (dofKind[dof] as DofKind) === DofKind.hinge);
}

/** The character with limits on hinges: each pair is a hinge and its lowest and highest value. */
function limited(character: Character, limits: readonly (readonly [number, number, number])[]) {
  const { skeleton } = character;
  const [qMin, qMax] = [skeleton.qMin.slice(), skeleton.qMax.slice()];
  for (const [index, low, high] of limits) {
    [qMin[index], qMax[index]] = [skeleton.qRest[index]! + low, skeleton.qRest[index]! + high];
  }
  return { ...character, skeleton: { ...skeleton, qMin, qMax } };
}

/** The character whose points follow these joints alone, each point one of them. */
function following(character: Character, joints: readonly number[]): Character {
  const { skin } = character;
  const entries = skin.entries.map((_, i) => skin.paletteJoint.indexOf(joints[i % joints.length]!));
  return { ...character, skin: { ...skin, entries, weights: skin.weights.map(() => 1) } };
}

describe('the poses of a stress suite', () => {
  it('bend and twist a joint that turns freely, about axes at right angles', () => {
    const labels = ['bend', 'side'].flatMap((name) => [`${name} 120°`, `${name} −120°`]);
    expect(labelsOf(tube)).toEqual(
      [...labels, 'twist 90°', 'twist −90°'].map((label) => `joint 02 · ${label}`),
    );
    const [bend, , side, , twist] = posesOf(tube);
    expect(twist!.axis[1]).toBeCloseTo(1, 12);
    for (const [a, b] of [
      [bend, side],
      [side, twist],
      [twist, bend],
    ]) {
      expect(a!.axis.reduce((sum, value, i) => sum + value * b!.axis[i]!, 0)).toBeCloseTo(0, 12);
    }
  });

  it('go as far as they are told', () => {
    const ranges = { bend: 45 * degree, twist: 5 * degree };
    expect(new Set(posesOf(tube, ranges).map(({ angle }) => Math.round(angle / degree)))).toEqual(
      new Set([45, -45]), // a twist of 5° is no stress
    );
  });

  it('turn joints of a body no farther than such joints do, on both sides alike', async () => {
    const human = await readBundled('human');
    const labels = labelsOf(human);
    expect(labels).toContain('Right lower leg · bend 120°');
    expect(labels).toContain('Head · twist 50°');
    const of = (side: string): string[] =>
      labels
        .filter((label) => label.startsWith(`${side} `))
        .map((label) => label.slice(side.length).replace('−', ''));
    expect(of('Left').length).toBeGreaterThan(30);
    expect(of('Left').toSorted()).toEqual(of('Right').toSorted());
    // The root and the pelvis carry the whole mesh.
    expect(labels.filter((label) => /^(Root|Hips?)\b/i.test(label))).toEqual([]);
  });

  it('are the ends of the limits where a joint has some', () => {
    const [first, second] = hingesOf(tube.skeleton).slice(-2) as [number, number];
    const poses = posesOf(
      limited(tube, [
        [first, -0.5, 2],
        [second, 0, 0],
      ]),
    );
    const ends = poses.filter(({ q }) => q[first] !== tube.skeleton.qRest[first]);
    expect(ends.map(({ angle }) => angle)).toEqual([2, -0.5]);
    expect(poses.some(({ q }) => q[second] !== tube.skeleton.qRest[second])).toBe(false);
  });

  const limit = fc.tuple(
    fc.nat(99),
    fc.double({ min: -3, max: 0, noNaN: true }),
    fc.double({ min: 0, max: 3, noNaN: true }),
  );

  it('keep to all limits, and turn one joint that moves a part of the mesh', () => {
    fc.assert(
      fc.property(
        fc.constantFrom(...trees),
        fc.array(limit, { maxLength: 6 }),
        fc.array(fc.nat(99), { minLength: 1, maxLength: 4 }),
        (tree, limits, followed) => {
          const hinges = hingesOf(tree.skeleton);
          const joints = followed.map((each) => each % tree.skeleton.jointCount);
          const character = following(
            limited(
              tree,
              limits.flatMap(([at, low, high]) =>
                hinges.length > 0 ? [[hinges[at % hinges.length]!, low, high] as const] : [],
              ),
            ),
            joints,
          );
          const { skeleton } = character;
          for (const { joint, q } of posesOf(character)) {
            const end = subtreeEnd(skeleton, joint);
            const moved = new Set(joints.map((each) => each >= joint && each < end));
            expect(moved).toEqual(new Set([true, false]));
            const [from, to] = jointRange(skeleton, joint);
            const changed = [...q.keys()].filter((i) => q[i] !== skeleton.qRest[i]);
            expect(changed.length).toBeGreaterThan(0);
            for (const i of changed) {
              expect(i >= from && i < to).toBe(true);
              expect(q[i]).toBeGreaterThanOrEqual(skeleton.qMin[i]!);
              expect(q[i]).toBeLessThanOrEqual(skeleton.qMax[i]!);
            }
          }
        },
      ),
    );
  });

  it('keep the pose from which joints turn, but for the joint that turns', () => {
    const { skeleton } = tube;
    const q = skeleton.qRest.map((_, i) => i / 10);
    const [from, to] = jointRange(skeleton, 2);
    const fresh = posesOf(tube);
    stressPoses(tube, tube.skin, q).forEach((pose, i) => {
      pose.q.forEach((value, at) => {
        if (at < from || at >= to) expect(value).toBe(q[at]);
        else expect(value).toBeCloseTo(fresh[i]!.q[at]!, 12);
      });
    });
  });

  it('are none where nothing deforms', () => {
    expect(deformingJoints(tube.skeleton, following(tube, [2]).skin)).toEqual([]);
    expect(posesOf(following(tube, [2]))).toEqual([]);
  });
});

describe('the figures of a stress suite', () => {
  const pool = fullPool();
  const ids: readonly MethodId[] = ['rigid', 'linear-blend', 'dual-quaternion'];
  const base = 1;
  const actor = createActor(1, tube, 'linear-blend');
  const poses = posesOf(tube);

  function measured() {
    const work = stressOf(pool, actor, ids, base, poses);
    for (let result = work.next(); ; result = work.next()) if (result.done) return result.value;
  }
  const suite = measured();

  it('are exactly those of a comparison in the same pose', () => {
    for (const { pose, numbers } of suite.rows) {
      const evaluations = ids.map((method) => {
        const state = { ...actor, method, q: pose.q };
        return new Evaluator(state, pool).evaluate(state, 0);
      });
      const compared = compareWith(evaluations[base]!, evaluations);
      expect(numbers).toEqual(
        compared.map(({ difference: { largest, worst, mean }, volume }) => {
          return { largest, worst, mean, volume };
        }),
      );
      expect(numbers[0]!.largest).toBeGreaterThan(0);
    }
  });

  it('stand in one table, which has the order of the joints', () => {
    const [head, ...rows] = stressRows(tube.skeleton, suite);
    expect(head).toHaveLength(3 + 6 * ids.length);
    expect(head!.slice(0, 5)).toEqual([
      ...['joint', 'motion', 'degrees', 'rigid largest', 'lbs largest'],
    ]);
    expect(rows).toHaveLength(poses.length);
    expect(rows.map((row) => row.slice(0, 3))).toEqual([
      ...[
        ['joint 02', 'bend', 120],
        ['joint 02', 'bend', -120],
      ],
      ...[
        ['joint 02', 'side', 120],
        ['joint 02', 'side', -120],
      ],
      ...[
        ['joint 02', 'twist', 90],
        ['joint 02', 'twist', -90],
      ],
    ]);
    const largest = suite.rows[0]!.numbers[0]!.largest;
    expect(rows[0]![3]).toBeCloseTo(largest, 5);
    expect(rows[0]![6]).toBeCloseTo(largest / sizeOf(tube).height, 5);
  });

  it('are sorted with the largest first', () => {
    const sorted = worstFirst(suite.rows).map(({ largest }) => largest);
    expect(sorted).toEqual(suite.rows.map(({ largest }) => largest).toSorted((a, b) => b - a));
    expect(sorted[0]).toBe(Math.max(...suite.rows.flatMap((r) => r.numbers.map((n) => n.largest))));
  });

  it('come after as many steps as there are poses and methods, and may end early', () => {
    const work = stressOf(pool, actor, ids, base, poses);
    expect(work.next().value).toBe(1 / (poses.length * ids.length));
    expect(work.return(undefined as never).done).toBe(true);
    expect(work.next().done).toBe(true);
  });
});
