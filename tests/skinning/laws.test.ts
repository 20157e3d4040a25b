import { describe, expect, it } from 'vitest';
import { loadedKernels } from '../support/kernels.ts';
import { renumberJoints, renumberPoints, transformsOf } from '../fixtures/rig.ts';
import {
  manyInfluences,
  randomValues,
  rotatedTree,
  soundRigs,
  unitWeights,
} from '../fixtures/rigs.ts';
import { multiply, transform, type Vector } from '../reference/matrix.ts';
import { skinningMatrix } from '../reference/skinned-vertex.ts';
import { randomSource, shuffled } from '../support/random.ts';
import { boundingDiagonal, largestDifference, numbersAt } from '../support/compare.ts';
import { tolerances } from '../tolerances.ts';
import { skinRig } from './skin-rig.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';

/** Rigs with one root, which moves everything. */
const oneRootRigs = { 'rotated tree': rotatedTree, 'many influences': manyInfluences };

function boundFor(points: readonly Vector[]): number {
  return tolerances.skinning * boundingDiagonal(points);
}

describe.each(loadedKernels)('the laws of $id', (method) => {
  it.each(Object.entries(soundRigs))('identity: "%s" at rest is the rest mesh', (_, makeRig) => {
    const rig = makeRig();
    const { positions, normals } = skinRig(rig, method, rig.rest);
    expect(largestDifference(positions, rig.points.flat())).toBeLessThan(boundFor(rig.points));
    const restNormals = characterOfRig(rig).mesh.normals;
    expect(largestDifference(normals, restNormals)).toBeLessThan(tolerances.normals);
  });

  it.each(Object.entries(oneRootRigs))('rigid motion: "%s" follows its root', (_, makeRig) => {
    const rig = makeRig();
    const root = rig.joints.findIndex(({ parent }) => parent === -1);
    const moved = randomValues(rig, 21);
    const values = rig.rest.map((rest, joint) => (joint === root ? moved[joint]! : rest));
    const { characterFromJoint, jointFromBind } = transformsOf(rig, values);
    const motion = multiply(characterFromJoint[root]!, jointFromBind[root]!);

    const { positions } = skinRig(rig, method, values);
    const expected = rig.points.flatMap((point) => transform(motion, point));
    expect(largestDifference(positions, expected)).toBeLessThan(boundFor(rig.points));
    // The motion must be considerable, so that a method that never moves fails.
    expect(largestDifference(positions, rig.points.flat())).toBeGreaterThan(0.1);
  });

  // A method that looks at the whole posed mesh smooths over the border of two joints.
  it.skipIf('finish' in method)(
    'unit weight: a point of one joint moves as if it were part of it',
    () => {
      const rig = unitWeights();
      const values = randomValues(rig, 22);
      const transforms = transformsOf(rig, values);
      const { positions } = skinRig(rig, method, values);
      const expected = rig.points.flatMap((point, index) =>
        transform(skinningMatrix(rig.rows[index]![0]![0], transforms), point),
      );
      expect(largestDifference(positions, expected)).toBeLessThan(boundFor(rig.points));
    },
  );

  it.each(Object.entries(soundRigs))(
    'permutation: "%s" with its joints renumbered is the same',
    (_, makeRig) => {
      const rig = makeRig();
      const order = shuffled(randomSource(23), rig.joints.length);
      const values = randomValues(rig, 24);
      const { positions } = skinRig(rig, method, values);
      const renumbered = renumberJoints(rig, order);
      const renumberedValues = order.map((old) => values[old]!);
      const permuted = skinRig(renumbered, method, renumberedValues).positions;
      expect(largestDifference(permuted, positions)).toBeLessThan(boundFor(rig.points));
    },
  );

  it.each(Object.entries(soundRigs))(
    'permutation: "%s" with its points renumbered is the same, bit by bit',
    (_, makeRig) => {
      const rig = makeRig();
      const order = shuffled(randomSource(25), rig.points.length);
      const values = randomValues(rig, 26);
      const { positions } = skinRig(rig, method, values);
      const permuted = skinRig(renumberPoints(rig, order), method, values).positions;
      order.forEach((old, point) => {
        expect(numbersAt(permuted, point, 3)).toEqual(numbersAt(positions, old, 3));
      });
    },
  );
});
