import fc from 'fast-check';
import { expect, it } from 'vitest';
import { type Skin, skinWithRows } from '../../src/core/skin.ts';

type Row = readonly (readonly [entry: number, weight: number])[];

function packed(rows: readonly Row[]) {
  const start = [0];
  for (const row of rows) start.push(start.at(-1)! + row.length);
  const influences = rows.flat();
  return {
    start: Uint32Array.from(start),
    entries: Uint16Array.from(influences, ([entry]) => entry),
    weights: Float32Array.from(influences, ([, weight]) => weight),
  };
}

function skinOf(rows: readonly Row[]): Skin {
  const jointFromBind = new Float64Array(0);
  return { paletteJoint: Uint16Array.of(0), jointFromBind, normals: 'blended', ...packed(rows) };
}

const row = fc.array(fc.tuple(fc.nat(9), fc.float({ noNaN: true })), { maxLength: 4 });

it('has the given rows, and the old ones for all other points', () => {
  const points = fc.array(fc.tuple(row, fc.option(row, { nil: null })), { maxLength: 12 });
  fc.assert(
    fc.property(points, (pairs) => {
      const skin = skinOf(pairs.map(([before]) => before));
      const others = pairs.flatMap(([, after], point) => (after ? [{ point, after }] : []));
      const result = skinWithRows(
        skin,
        others.map(({ point }) => point),
        packed(others.map(({ after }) => after)),
      );
      expect(result).toEqual(skinOf(pairs.map(([before, after]) => after ?? before)));
    }),
  );
});

it('shares unchanged arrays with the given skin', () => {
  const skin = skinOf([[[0, 1]], [[1, 0.5], [2, 0.5]]]); // prettier-ignore
  const lighter = skinWithRows(skin, [1], packed([[[1, 0.25], [2, 0.5]]])); // prettier-ignore
  expect([lighter.start, lighter.entries]).toEqual([skin.start, skin.entries]);
  expect(lighter.start).toBe(skin.start);
  expect(lighter.entries).toBe(skin.entries);
  expect(skinWithRows(skin, [0], packed([[[5, 1]]])).start).toBe(skin.start);
  expect(skinWithRows(skin, [0], packed([[]])).start).not.toBe(skin.start);
});
