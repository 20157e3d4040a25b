import { expect, it } from 'vitest';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { poseFromJson } from '../../src/formats/pose-json.ts';
import { largestDifference, numbersAt } from '../support/compare.ts';
import { readOne } from '../support/files.ts';
import { tolerances } from '../tolerances.ts';
import { describeWithShared, sharedJson } from './shared-material.ts';

interface EulerRow {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  /** Products by name, three rows of three. */
  readonly m: { readonly RxRyRz: readonly number[] };
}

const path = 'reference/euler.json';

describeWithShared('the rotation of a 6.837 joint', [path], () => {
  it('is Rx · Ry · Rz: z turns first', async () => {
    const { skeleton } = await readOne({ 'a.skel': '0 0 0 -1\n' });
    const { rows } = sharedJson(path) as { rows: readonly EulerRow[] };
    expect(rows.length).toBeGreaterThan(20);
    for (const { x, y, z, m } of rows) {
      const json = { joints: { '#0': [x, y, z] } };
      const world = jointMatrices(skeleton, poseFromJson('p', json, skeleton).value!.q);
      const columns = [0, 1, 2].map((column) => numbersAt(world, column, 4));
      const rowMajor = [0, 1, 2].flatMap((row) => columns.map((column) => column[row]!));
      expect(largestDifference(rowMajor, m.RxRyRz)).toBeLessThan(tolerances.referenceMatrices);
    }
  });
});
