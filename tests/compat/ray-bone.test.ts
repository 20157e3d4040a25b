import { expect, it } from 'vitest';
import { rayCapsule, rayCylinder } from '../../src/core/ray.ts';
import { tolerances } from '../tolerances.ts';
import { describeWithShared, sharedJson } from './shared-material.ts';

type Triple = readonly [number, number, number];

interface RayRow {
  /** The ends of the bone, and its radius. */
  readonly A: Triple;
  readonly B: Triple;
  readonly r: number;
  readonly origin: Triple;
  readonly dir: Triple;
  /** Distances of the first hit; null is a miss. */
  readonly side_only: number | null;
  readonly capsule: number | null;
}

const path = 'reference/ray_bone.json';

describeWithShared('a ray against a bone', [path], () => {
  const tests = [
    ['the side of a cylinder', rayCylinder, 'side_only'],
    ['a capsule', rayCapsule, 'capsule'],
  ] as const;

  it.each(tests)('meets %s where the table says', (_, distanceTo, column) => {
    const { rows } = sharedJson(path) as { rows: readonly RayRow[] };
    expect(rows.length).toBeGreaterThan(50);
    for (const row of rows) {
      const ray = { origin: row.origin, direction: row.dir };
      const found = distanceTo(ray, row.A, row.B, row.r);
      const expected = row[column];
      if (expected === null) expect(found).toBe(Infinity);
      else expect(Math.abs(found - expected)).toBeLessThan(tolerances.rayDistance);
    }
  });
});
