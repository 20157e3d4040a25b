import { expect, it } from 'vitest';
import { tellingPoses } from '../../src/posing/telling-poses.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';

it('a character without elbows twists and bends a joint that shares points, and no other', () => {
  const character = characterOfRig(rotatedTree());
  const { skeleton } = character;
  const q = skeleton.qRest.slice();
  for (const pose of tellingPoses(character, q)) {
    const name = /^(?:Twist|Bend) (.*)$/.exec(pose.label)![1]!;
    const joint = skeleton.names.indexOf(name);
    expect(joint).toBeGreaterThanOrEqual(0);
    const changed = [...pose.q.keys()].filter((i) => pose.q[i] !== q[i]);
    expect(changed.length).toBeGreaterThan(0);
    for (const i of changed) {
      expect(pose.q[i]).toBeGreaterThanOrEqual(skeleton.qMin[i]!);
      expect(pose.q[i]).toBeLessThanOrEqual(skeleton.qMax[i]!);
    }
  }
});
