import { describe, expect, it } from 'vitest';
import { largestBindError } from '../../src/skinning/bind-error.ts';
import { characterOfRig, qOfValues } from '../fixtures/character-of-rig.ts';
import { transformsOf } from '../fixtures/rig.ts';
import type { Rig } from '../fixtures/rig.ts';
import { forest, manyInfluences, randomValues, rotatedTree } from '../fixtures/rigs.ts';
import { type Joint, reachOf, characterFromJoints } from '../reference/kinematics.ts';
import { columnMajor, largestDifference } from '../support/compare.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { randomBetween, randomRotation, randomSource } from '../support/random.ts';
import { tolerances } from '../tolerances.ts';

const rigs = { 'rotated tree': rotatedTree, forest, 'many influences': manyInfluences };

/**
 * A chain of 4,096 joints in which every joint except the first has its parent after it in the
 * file.
 */
function deepChain(): Rig {
  const random = randomSource(5);
  const count = 4096;
  const joints = Array.from({ length: count }, (_, index): Joint => ({
    parent: index === count - 1 ? -1 : index + 1,
    offset: [0, randomBetween(random, 0, 0.01), 0],
    rotation: randomRotation(random, 0.3),
    freedoms: [{ kind: 'hinge', axis: [1, 0, 0] }],
  }));
  const rest = joints.map(() => [[randomBetween(random, -0.1, 0.1)]]);
  return { joints, rest, points: [[0, 0, 0]], triangles: [], rows: [[[0, 1]]] };
}

/**
 * Joints as the courses have them, without a rotation at rest: hinges about coordinate axes in any
 * order and number. Some joints also have a slide, or a hinge about another axis.
 */
function coordinateHinges(): Rig {
  const random = randomSource(6);
  const axes = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const joints = Array.from({ length: 200 }, (_, index): Joint => {
    const hinges = Array.from({ length: index % 5 }, () => axes[Math.floor(random() * 3)]!);
    const others: Joint['freedoms'] = [
      { kind: 'slide', axis: axes[index % 3]! },
      { kind: 'hinge', axis: axes[index % 3]!.map((value) => -value) },
    ];
    return {
      parent: index === 0 ? -1 : Math.floor(random() * index),
      offset: axes.map(() => randomBetween(random, -0.3, 0.3)),
      // A rotation at rest may be so small that its w is 1.
      rotation: [index % 11 === 5 ? 1e-9 : 0, 0, 0, 1],
      freedoms: [
        ...hinges.map((axis) => ({ kind: 'hinge', axis }) as const),
        ...(index % 7 === 0 ? others : []),
      ],
    };
  });
  const rest = joints.map(({ freedoms }) => freedoms.map(() => [0]));
  return { joints, rest, points: [[0, 0, 0]], triangles: [], rows: [[[0, 1]]] };
}

function worldDifference(rig: Rig, values = randomValues(rig, 31)): number {
  const { skeleton } = characterOfRig(rig);
  const world = jointMatrices(skeleton, qOfValues(skeleton, values));
  const expected = characterFromJoints(rig.joints, values);
  return expected.reduce((largest, matrix, source) => {
    const at = skeleton.jointOfSource[source]! * 16;
    const difference = largestDifference(world.subarray(at, at + 16), columnMajor(matrix));
    return Math.max(largest, difference);
  }, 0);
}

describe('forward kinematics', () => {
  it.each(Object.entries(rigs))('of the rig "%s" equals the oracle', (_, makeRig) => {
    const rig = makeRig();
    const bound = tolerances.kinematics * reachOf(rig.joints);
    expect(worldDifference(rig)).toBeLessThan(bound);
    expect(worldDifference(rig, rig.rest)).toBeLessThan(bound);
  });

  it.each([1, Math.PI, 100])('of coordinate hinges up to ±%d equals the oracle', (angle) => {
    const rig = coordinateHinges();
    const bound = tolerances.kinematics * reachOf(rig.joints);
    for (const seed of [33, 34, 35]) {
      expect(worldDifference(rig, randomValues(rig, seed, angle))).toBeLessThan(bound);
    }
  });

  it.each([0, 0.25, 0.5, 0.75, 1, -0.5, -1, 2])(
    'of coordinate hinges at %d × π equals the oracle',
    (turns) => {
      const rig = coordinateHinges();
      const values = rig.joints.map(({ freedoms }) => freedoms.map(() => [turns * Math.PI]));
      const bound = tolerances.kinematics * reachOf(rig.joints);
      expect(worldDifference(rig, values)).toBeLessThan(bound);
    },
  );

  it('equals the oracle down a chain of 4,096 joints', () => {
    const rig = deepChain();
    expect(worldDifference(rig)).toBeLessThan(tolerances.kinematics * reachOf(rig.joints));
  });

  it('leaves the values alone and gives the same matrices again', () => {
    const rig = rotatedTree();
    const { skeleton } = characterOfRig(rig);
    const q = qOfValues(skeleton, randomValues(rig, 32));
    const before = q.slice();
    expect(jointMatrices(skeleton, q)).toEqual(jointMatrices(skeleton, q));
    expect(q).toEqual(before);
  });
});

describe('bind matrices', () => {
  it.each(Object.entries(rigs))('of the rig "%s" equal the inverses of the oracle', (_, make) => {
    const rig = make();
    const { skeleton, skin } = characterOfRig(rig);
    const bound = tolerances.kinematics * reachOf(rig.joints);
    transformsOf(rig, rig.rest).jointFromBind.forEach((matrix, source) => {
      const at = skeleton.jointOfSource[source]! * 16;
      const built = skin.jointFromBind.subarray(at, at + 16);
      expect(largestDifference(built, columnMajor(matrix))).toBeLessThan(bound);
    });
  });

  it.each(Object.entries({ ...rigs, 'deep chain': deepChain }))(
    'of the rig "%s" undo the file\'s pose (the handout\'s own check, 4.4.1)',
    (_, makeRig) => {
      const { skeleton, skin } = characterOfRig(makeRig());
      expect(largestBindError(skeleton, skin)).toBeLessThan(tolerances.bindError);
    },
  );

  it('are reported as wrong where they are', () => {
    const { skeleton, skin } = characterOfRig(rotatedTree());
    const jointFromBind = skin.jointFromBind.slice();
    jointFromBind[5] = jointFromBind[5]! + 1e-6;
    expect(largestBindError(skeleton, { ...skin, jointFromBind })).toBeGreaterThan(5e-7);
  });
});
