import { describe, expect, it } from 'vitest';
import { loadedKernels } from '../support/kernels.ts';
import { allRigs, randomValues } from '../fixtures/rigs.ts';
import { boundingDiagonal, largestDifference } from '../support/compare.ts';
import { tolerances } from '../tolerances.ts';
import { oracleOf, skinRig, skinRigByOracle } from './skin-rig.ts';

const poseSeeds = [11, 12, 13];

// Taken from the registry, so that no method can be forgotten.
describe.each(loadedKernels)('$id against the float64 oracle', (method) => {
  it('has an oracle', () => {
    expect(oracleOf(method)).toBeDefined();
  });

  it.each(Object.entries(allRigs))('puts the points of the rig "%s" in place', (_, makeRig) => {
    const rig = makeRig();
    for (const seed of poseSeeds) {
      const values = randomValues(rig, seed);
      const { positions } = skinRig(rig, method, values);
      const expected = skinRigByOracle(rig, method, values).positions;
      const bound = tolerances.skinning * boundingDiagonal(rig.points);
      expect(largestDifference(positions, expected)).toBeLessThan(bound);
    }
  });

  it.each(Object.entries(allRigs))('turns the normals of the rig "%s"', (_, makeRig) => {
    const rig = makeRig();
    for (const seed of poseSeeds) {
      // Bent less, because the normal of a part that folds through itself is meaningless.
      const values = randomValues(rig, seed, 0.5);
      const { normals } = skinRig(rig, method, values);
      const expected = skinRigByOracle(rig, method, values).normals;
      expect(largestDifference(normals, expected)).toBeLessThan(tolerances.normals);
    }
  });
});
