import { expect, it } from 'vitest';
import { turnFreely, turnStart } from '../../src/posing/turn-joint.ts';
import { dragRig, worldOf } from '../posing/drag-rigs.ts';
import { inverse, multiply } from '../reference/matrix.ts';
import { largestDifference } from '../support/compare.ts';
import { tolerances } from '../tolerances.ts';
import { describeWithShared, sharedJson } from './shared-material.ts';

interface EulerRow {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  /** Products by name, w x y z. */
  readonly quat_wxyz: Readonly<Record<string, readonly number[]>>;
}

const path = 'reference/euler.json';

describeWithShared('three hinges that take a rotation', [path], () => {
  const { rows } = sharedJson(path) as { rows: readonly EulerRow[] };

  it.each(['xyz', 'xzy', 'yxz', 'yzx', 'zxy', 'zyx'])(
    'in the order %s have its angles',
    (order) => {
      expect(rows.length).toBeGreaterThan(20);
      const name = Array.from(order, (axis) => `R${axis}`).join('');
      rows.forEach((row, seed) => {
        const rig = dragRig(order, seed);
        const angles = Array.from(order, (axis) => row[axis as 'x' | 'y' | 'z']);
        const zero = rig.q.slice().fill(0, 4);
        const [w, ...axis] = row.quat_wxyz[name]!;
        // The file's rotation is in the joint's frame, but a turn is in the character's space.
        const frame = worldOf(rig, zero);
        const vector = [0, 1, 2].map((r) => axis.reduce((sum, v, c) => sum + frame[r]![c]! * v, 0));
        const near = Float64Array.from([...zero.subarray(0, 4), ...angles]);
        const start = turnStart(rig.skeleton, 1, zero);
        const found = turnFreely(start, [vector[0]!, vector[1]!, vector[2]!, w!], near)!;
        expect(largestDifference(found.subarray(4), angles)).toBeLessThan(
          tolerances.referenceMatrices,
        );
        const turned = multiply(inverse(frame), worldOf(rig, found)).flat();
        const expected = multiply(inverse(frame), worldOf(rig, near)).flat();
        expect(largestDifference(turned, expected)).toBeLessThan(tolerances.referenceMatrices);
      });
    },
  );
});
