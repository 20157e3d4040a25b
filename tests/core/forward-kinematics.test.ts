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
