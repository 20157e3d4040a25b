import { expect, it } from 'vitest';
import { differenceOf, sizeOf } from '../../src/evaluation/comparison/difference.ts';
import { tellingPoses } from '../../src/posing/telling-poses.ts';
import { dualQuaternion } from '../../src/skinning/dual-quaternion.ts';
import { linearBlend } from '../../src/skinning/linear-blend.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';
import { bundledIds, readBundled } from '../support/bundled.ts';
import { skinVertices } from '../support/skin-vertices.ts';

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

// The lab offers them where methods differ by less than a hundredth of the height.
it.each(bundledIds)('a pose that is offered for %s shows a difference', async (id) => {
  const character = await readBundled(id);
  const { mesh, morphs, skeleton, skin } = character;
  const poses = tellingPoses(character, skeleton.qRest);
  expect(poses.length).toBeGreaterThan(0);
  const morphWeights = new Float64Array(morphs.length);
  for (const { label, q } of poses) {
    const [blend, dual] = [linearBlend, dualQuaternion].map(
      (method) => skinVertices(character, skin, { q, morphWeights }, method).positions,
    );
    const { largest } = differenceOf(dual!, blend!, mesh.pointCount);
    expect(largest, label).toBeGreaterThan(0.01 * sizeOf(character).height);
  }
});
