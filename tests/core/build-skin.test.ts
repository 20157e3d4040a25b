import { describe, expect, it } from 'vitest';
import { buildCharacter } from '../../src/core/build-character.ts';
import { largestInfluenceCount, noJoint, normalizeSkin } from '../../src/core/skin.ts';
import { characterOfRig, partsOfRig } from '../fixtures/character-of-rig.ts';
import { forest, manyInfluences, oddWeights, rotatedTree, unitWeights } from '../fixtures/rigs.ts';
import type { Rig } from '../fixtures/rig.ts';
import type { Influence } from '../reference/skinned-vertex.ts';

/** The rig with these rows for its first points; all other points follow joint 0. */
function withRows(rig: Rig, rows: readonly (readonly Influence[])[]): Rig {
  return { ...rig, rows: rig.points.map((_, point) => rows[point] ?? [[0, 1]]) };
}

/** The row of a built point, as [file index of the joint, weight]. */
function rowOf(rig: Rig, point: number): number[][] {
  const { skeleton, skin } = characterOfRig(rig);
  return Array.from({ length: skin.start[point + 1]! - skin.start[point]! }, (_, i) => {
    const at = skin.start[point]! + i;
    return [skeleton.sourceIndex[skin.paletteJoint[skin.entries[at]!]!]!, skin.weights[at]!];
  });
}

function messagesOf(rig: Rig) {
  return buildCharacter(partsOfRig(rig)).diagnostics;
}

describe('buildSkin', () => {
  it('keeps every influence of every row', () => {
    const rig = manyInfluences();
    expect(largestInfluenceCount(characterOfRig(rig).skin)).toBe(24);
    rig.rows.forEach((row, point) => {
      const expected = row.map(([joint, weight]) => [joint, Math.fround(weight)]);
      expect(rowOf(rig, point)).toEqual(expected);
    });
  });

  it('says nothing about rows that sum to one, nearly', () => {
    expect(messagesOf(rotatedTree())).toEqual([]);
    const nearly = withRows(unitWeights(), [[[0, 0.9995]], [[0, 1.0005]]]);
    expect(messagesOf(nearly)).toEqual([]);
  });

  it('lets rows without weights follow the first root of the file, and says which', () => {
    const rig = withRows(forest(), [[], [[0, 0]], [[0, 1e-7]]]);
    expect([0, 1, 2].map((point) => rowOf(rig, point))).toEqual([[[1, 1]], [[1, 1]], [[1, 1]]]);
    expect(messagesOf(rig)).toMatchObject([
      {
        severity: 'warning',
        code: 'character/weight-zero',
        found: 'none for 3: vertex 1, 2, 3',
        effect: 'they follow the root rigidly',
      },
    ]);
  });

  it('keeps negative weights and names the first', () => {
    const row: Influence[] = [
      [0, 1.5],
      [2, -0.5],
    ];
    const rig = withRows(rotatedTree(), [row, row, row, row, row, row]);
    expect(rowOf(rig, 0)).toEqual(row);
    expect(messagesOf(rig)).toMatchObject([
      { code: 'character/weight-negative', found: 'negative ones for 6: vertex 1, 2, 3, …' },
    ]);
  });

  it('uses rows of another sum as they are and names the worst', () => {
    const rig = withRows(unitWeights(), [[[0, 0.98]], [[0, 2]], [[0, 1]]]);
    expect(rowOf(rig, 1)).toEqual([[0, 2]]);
    expect(messagesOf(rig)).toMatchObject([
      { code: 'character/weight-sum', found: '0.98 to 2 for 2' },
    ]);
  });

  it('makes no skin if a row names a joint that does not exist', () => {
    const rig = withRows(unitWeights(), [[[0, 1]], [[2, 1]], [[9, 1]], [[300, 1]]]);
    const { value, diagnostics } = buildCharacter(partsOfRig(rig));
    expect([...value!.skin.paletteJoint]).toEqual([noJoint]);
    expect(diagnostics).toMatchObject([
      {
        severity: 'error',
        code: 'character/index',
        expected: 'joints from 0 to 8',
        found: 'joint 9 at vertex 3',
      },
    ]);
  });

  it('leaves out weights under a millionth, whatever their sign', () => {
    const row: Influence[] = [
      [0, 1],
      [1, 9e-7],
      [2, -9e-7],
      [3, 1e-6],
      [4, 1e-45],
    ];
    expect(rowOf(withRows(rotatedTree(), [row]), 0)).toEqual([
      [0, 1],
      [3, Math.fround(1e-6)],
    ]);
  });

  it('makes no skin if the number of rows is not that of the points', () => {
    const rig = rotatedTree();
    const { value, diagnostics } = buildCharacter(partsOfRig({ ...rig, rows: rig.rows.slice(1) }));
    expect(value?.mesh.pointCount).toBe(62);
    expect([...value!.skin.paletteJoint]).toEqual([noJoint]);
    expect(diagnostics).toMatchObject([
      { severity: 'error', code: 'character/count', file: 'rig.attach', found: '61 rows' },
    ]);
  });
});

describe('normalizeSkin', () => {
  it('divides each row by its sum and leaves the skin that it is given alone', () => {
    const { skin } = characterOfRig(oddWeights());
    const before = skin.weights.slice();
    const { weights, start } = normalizeSkin(skin);
    expect(skin.weights).toEqual(before);
    for (let point = 0; point + 1 < start.length; point++) {
      const row = weights.subarray(start[point], start[point + 1]);
      expect(row.reduce((sum, weight) => sum + weight, 0)).toBeCloseTo(1, 6);
    }
  });

  it.each([
    [0.5, -0.5],
    [1000, -999.5],
  ])('leaves rows whose sum is next to nothing as they are: %d and %d', (a, b) => {
    const row: Influence[] = [
      [0, a],
      [1, b],
    ];
    const { weights } = normalizeSkin(characterOfRig(withRows(rotatedTree(), [row])).skin);
    expect([...weights.subarray(0, 2)]).toEqual([a, b]);
  });

  it('normalizes rows of small weights too', () => {
    const row: Influence[] = [
      [0, 3e-6],
      [1, 1e-6],
    ];
    const { weights } = normalizeSkin(characterOfRig(withRows(rotatedTree(), [row])).skin);
    expect(weights[0]).toBeCloseTo(0.75, 5);
  });
});
