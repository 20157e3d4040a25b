import { expect, it } from 'vitest';
import { posedRotation } from '../../src/core/bone-frames.ts';
import { boneWeights } from '../../src/core/bone-weights.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { bonesAt, framesOf, weighedCount } from '../../src/ui/bone-facts.ts';
import { fixedText } from '../../src/ui/number-text.ts';
import { largestDifference } from '../support/compare.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';

it.each(Object.entries(allRigs))(
  '%s: each joint has its bones, each bone its numbers',
  (_, rig) => {
    const character = characterOfRig(rig());
    const { skeleton, skin } = character;
    const frames = framesOf(skeleton);
    expect(framesOf(skeleton)).toBe(frames);
    const weights = boneWeights(frames, skin);
    for (let joint = 0; joint < skeleton.jointCount; joint++) {
      const children = [...skeleton.parents].filter((parent) => parent === joint).length;
      const bones = bonesAt(frames, joint);
      expect(bones).toHaveLength(children > 0 ? children : skeleton.parents[joint] === -1 ? 0 : 1);
      for (const bone of bones) {
        expect(frames[bone]![children > 0 ? 'source' : 'destination']).toBe(joint);
        const row = weights.points.subarray(weights.start[bone], weights.start[bone + 1]);
        expect(weighedCount(character, bone)).toBe(row.length);
        const atRest = posedRotation(frames, bone, jointMatrices(skeleton, skeleton.qRest));
        expect(largestDifference(atRest, frames[bone]!.rotation)).toBeLessThan(1e-12);
      }
    }
  },
);

it('numbers have three decimals, and zero has no sign', () => {
  expect([1, -0.0004, -0.0006, 12.34567].map(fixedText)).toEqual([
    '1.000',
    '0.000',
    '-0.001',
    '12.346',
  ]);
});
