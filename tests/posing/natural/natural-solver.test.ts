import { beforeAll, describe, expect, it } from 'vitest';
import type { Character } from '../../../src/core/character.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { jointRange } from '../../../src/core/pose.ts';
import { dls } from '../../../src/posing/ik/dls.ts';
import type { IkProblem } from '../../../src/posing/ik/problem.ts';
import {
  fromNatural,
  naturalSkeleton,
  toNatural,
} from '../../../src/posing/natural/natural-skeleton.ts';
import { plainNatures } from '../../../src/posing/natural/nature-settings.ts';
import { naturesInUse } from '../../../src/posing/natural/natures-in-use.ts';
import { naturesOf } from '../../../src/posing/natural/natures.ts';
import { readBundled } from '../../support/bundled.ts';
import { largestDifference } from '../../support/compare.ts';
import { randomBetween, randomRotation, randomSource } from '../../support/random.ts';

describe.each(['human', 'mannequin'])('natural coordinates of the %s', (id) => {
  let character: Character;

  beforeAll(async () => {
    character = await readBundled(id);
  });

  /** Random rotations of all joints, whether by hinges or by balls. */
  function randomPose(seed: number): Float64Array {
    const { skeleton } = character;
    const random = randomSource(seed);
    const q = skeleton.qRest.map((value) => value + randomBetween(random, -1, 1));
    for (let joint = 0; joint < skeleton.jointCount; joint++) {
      const [from, to] = jointRange(skeleton, joint);
      if (id === 'mannequin') q.set(randomRotation(random, 2), to - 4);
      expect(to).toBeGreaterThan(from);
    }
    return q;
  }

  it('place every joint as the values of the file do, there and back', () => {
    const { skeleton } = character;
    const natural = naturalSkeleton(skeleton, naturesOf(character));
    for (let seed = 0; seed < 5; seed++) {
      const q = randomPose(seed);
      const values = toNatural(natural, q);
      const placed = jointMatrices(natural.skeleton, values);
      expect(largestDifference(placed, jointMatrices(skeleton, q))).toBeLessThan(1e-9);
      // Back from other values near by: the same rotations.
      const back = fromNatural(natural, values, new Float64Array(values.length), q);
      expect(largestDifference(jointMatrices(skeleton, back), placed)).toBeLessThan(1e-9);
      expect(largestDifference(back, q)).toBeLessThan(1e-6);
    }
  });

  it('leave a pose that holds as it is, bit by bit, also outside its ranges', () => {
    const { skeleton } = character;
    const q = randomPose(7);
    const joint = skeleton.names.indexOf('Right hand');
    const matrices = jointMatrices(skeleton, q);
    const target = [12, 13, 14].map((i) => matrices[joint * 16 + i]!) as [number, number, number];
    const joints = ['Right shoulder', 'Right upper arm', 'Right forearm'];
    const problem: IkProblem = {
      skeleton,
      goals: [{ joint, point: [0, 0, 0], target, weight: 1 }],
      joints: joints.map((name) => skeleton.names.indexOf(name)),
      reference: q,
      natures: naturesOf(character),
    };
    const solved = dls.solve(problem);
    expect(solved.q).toEqual(q);
    expect(solved.status).toBe('reached');
  });
});

describe('natures in use', () => {
  it("are none when switched off, and a user's own in place of what was found", async () => {
    const human = await readBundled('human');
    const found = naturesOf(human);
    expect(naturesInUse(human, plainNatures)).toBe(found);
    expect(naturesInUse(human, { isOn: false, own: [] })).toEqual([]);
    const { joint } = found[3]!;
    const range = [-0.1, 0.2] as const;
    const own = { joint, stiffness: 7, bend: range, side: range, twist: range };
    const settings = { isOn: true, own: [own] };
    const used = naturesInUse(human, settings);
    expect(used[3]).toEqual({ ...found[3], ...own });
    expect(used.filter((nature, i) => nature !== found[i])).toHaveLength(1);
    expect(naturesInUse(human, settings)).toBe(used);
  });
});
