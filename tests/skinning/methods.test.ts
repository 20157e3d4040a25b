import { describe, expect, it } from 'vitest';
import { loadedKernels } from '../support/kernels.ts';
import { allRigs, randomValues } from '../fixtures/rigs.ts';
import { boundingDiagonal, largestDifference } from '../support/compare.ts';
import { tolerances } from '../tolerances.ts';
import { oracleOf, skinRig, skinRigByOracle } from './skin-rig.ts';

const poseSeeds = [11, 12, 13];

// From the registry, so that a new method cannot skip them.
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
      // Bent less, since the normal of a part that folds through itself means nothing.
      const values = randomValues(rig, seed, 0.5);
      const { normals } = skinRig(rig, method, values);
      const expected = skinRigByOracle(rig, method, values).normals;
      expect(largestDifference(normals, expected)).toBeLessThan(tolerances.normals);
    }
  });
});
