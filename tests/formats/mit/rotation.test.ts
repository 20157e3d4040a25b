import { describe, expect, it } from 'vitest';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { poseFromJson } from '../../../src/formats/pose-json.ts';
import { multiply, rotationAbout, translation } from '../../reference/matrix.ts';
import { columnMajor, largestDifference } from '../../support/compare.ts';
import { readOne } from '../../support/files.ts';
import { tolerances } from '../../tolerances.ts';

describe('a joint of 6.837', () => {
  it('turns by Rx · Ry · Rz after its offset, the root displaced in the world', async () => {
    const { skeleton } = await readOne({ 'a.skel': '1 2 3 -1\n0 5 0 0\n' });
    const json = { root: [10, 20, 30], joints: { '#0': [0.3, -1.1, 2], '#1': [-2, 0.4, 0.9] } };
    const { value } = poseFromJson('p', json, skeleton);
    const rotation = (x: number, y: number, z: number) =>
      multiply(
        rotationAbout([1, 0, 0], x),
        multiply(rotationAbout([0, 1, 0], y), rotationAbout([0, 0, 1], z)),
      );
    const root = multiply(translation([11, 22, 33]), rotation(0.3, -1.1, 2));
    const child = multiply(root, multiply(translation([0, 5, 0]), rotation(-2, 0.4, 0.9)));
    const expected = [...columnMajor(root), ...columnMajor(child)];
    const bound = tolerances.kinematics * 50;
    expect(largestDifference(jointMatrices(skeleton, value!.q), expected)).toBeLessThan(bound);
  });
});
