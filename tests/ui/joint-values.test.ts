import { expect, it } from 'vitest';
import { jointValues, valueName } from '../../src/ui/joint-values.ts';
import { rotationOrder } from '../../src/ui/controls/rotation-order.ts';
import { legSkel } from '../support/cse169-files.ts';
import { readContents } from '../support/files.ts';
import { squarePmd } from '../support/pmd-files.ts';

async function skeletonOf(name: string, content: string | Uint8Array) {
  const { characters } = await readContents({ [name]: content });
  return characters[0]!.character.skeleton;
}

it('a ball has three angles in place of its quaternion, after the slides of its joint', async () => {
  const skeleton = await skeletonOf('a.pmd', squarePmd);
  const values = jointValues(skeleton, 0);
  expect(values.map(valueName)).toEqual(['Move X', 'Move Y', 'Move Z', 'X', 'Y', 'Z']);
  expect(values.map(({ index }) => index)).toEqual([0, 1, 2, 3, 3, 3]);
  expect(jointValues(skeleton, 1).map(valueName)).toEqual(['X', 'Y', 'Z']);
  expect(rotationOrder(skeleton)).toBe('R = Rx · Ry · Rz');
});

it('hinges are listed by axis, whatever their order of application', async () => {
  const skeleton = await skeletonOf('leg.skel', legSkel);
  const angles = jointValues(skeleton, 1).filter(({ isAngle }) => isAngle);
  expect(angles.map(valueName)).toEqual(['X', 'Y', 'Z']);
  expect(angles.every(({ ofBall }) => !ofBall)).toBe(true);
  expect(angles[0]!.index).toBeGreaterThan(angles[2]!.index);
  expect(rotationOrder(skeleton)).toBe('R = Rz · Ry · Rx');
});
