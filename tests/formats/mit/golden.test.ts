import { describe, expect, it } from 'vitest';
import { numbersAt } from '../../support/compare.ts';
import { shown } from '../../support/diagnose.ts';
import { readContents, readOne, textOf } from '../../support/files.ts';
import { golden, oddities } from '../../support/golden.ts';

const contents = golden(...oddities);
const character = await readOne(contents);
const { skeleton, mesh, skin } = character;

/** [file index of the joint, weight] of a point. */
function rowOf(point: number): number[][] {
  const row: number[][] = [];
  for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
    const joint = skin.paletteJoint[skin.entries[i]!]!;
    row.push([skeleton.sourceIndex[joint]!, skin.weights[i]!]);
  }
  return row;
}

describe('the golden files with all their oddities', () => {
  it('have the bytes that they are kept for', () => {
    const [skel, obj, attach] = oddities.map((name) => textOf(contents[name] as Uint8Array));
    expect(skel).toMatch(/^\uFEFF.*\r\n[^]*-1$/);
    expect(obj).toMatch(/\\\r\r\n/);
    expect(attach).toMatch(/^[^\n]*$/);
    expect(attach!.split('\r')).toHaveLength(9);
  });

  it('give the skeleton, root first', () => {
    expect([...skeleton.sourceIndex]).toEqual([2, 0, 1]);
    expect([...skeleton.parents]).toEqual([-1, 0, 1]);
    expect([...skeleton.restOffsets]).toEqual([0.1, 0.25, 3, 0, 1, 0, 0.5, -0, 0]);
    expect(skeleton.names).toEqual(['joint 02', 'joint 00', 'joint 01']);
  });

  it('give the points in order and split one where texture coordinates differ', () => {
    expect(mesh.pointCount).toBe(9);
    expect([...mesh.pointOf]).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 3, 2]);
    expect(numbersAt(mesh.positions, 1, 3)).toEqual([1, 0, 0]);
    expect(numbersAt(mesh.positions, 9, 3)).toEqual([0, 1, 0]);
    expect([3, 9].map((vertex) => numbersAt(mesh.uvs!, vertex, 2))).toEqual([
      [0, 1],
      [1, 0],
    ]);
  });

  it('give the faces by material, the concave one cut inside', () => {
    expect(mesh.submeshes).toEqual([
      { material: 'dark skin #2', firstIndex: 0, indexCount: 6 },
      { material: 'plain', firstIndex: 6, indexCount: 9 },
    ]);
    expect([...mesh.indices.subarray(0, 6)]).toEqual([0, 1, 2, 0, 2, 3]);
    const arrow = [...mesh.indices.subarray(6, 12)];
    // Both halves contain the dent 6 and the tip 4, because the other diagonal is outside.
    expect([arrow.slice(0, 3), arrow.slice(3)].map((half) => half.toSorted())).toEqual(
      expect.arrayContaining([
        [4, 5, 6],
        [4, 6, 7],
      ]),
    );
    expect([...mesh.indices.subarray(12)]).toEqual([0, 9, 10]);
  });

  it('give the weights: column i is joint i + 1', () => {
    expect(Array.from({ length: 9 }, (_, point) => rowOf(point))).toEqual([
      [[1, 1]],
      [
        [1, 0.5],
        [2, 0.5],
      ],
      [[2, 1]],
      [
        [1, 0.25],
        [2, 0.75],
      ],
      [
        [1, -0.5],
        [2, 1.5],
      ],
      [[2, 1]],
      [
        [1, Math.fround(0.1)],
        [2, Math.fround(0.9)],
      ],
      [[1, Math.fround(0.98)]],
      [[2, 1]],
    ]);
  });

  it('are read with these messages', async () => {
    const { diagnostics } = await readContents(contents);
    expect(shown(diagnostics)).toEqual([
      'warning: oddities.skel:5:16: expected the root to be the first joint, found "joint 2" ' +
        '[skel/root]; joint 0 still has no column of weights, as the format has it',
      'warning: oddities.obj:2:1: expected the material library among the files, ' +
        'found "mtllib ../oddities.mtl" [obj/missing]; the surface is plain',
      'warning: oddities.attach:6: expected at least one weight for every vertex, ' +
        'found "none for 1: vertex 6" [character/weight-zero]; they follow the root rigidly',
      'warning: oddities.attach:5: expected weights of at least 0, found "negative ones for ' +
        '1: vertex 5" [character/weight-negative]; they are kept as they are',
      'warning: oddities.attach:8: expected weights that sum to 1 for every vertex, found "0.98 for 1" ' +
        '[character/weight-sum]; they are used as they are, vertex 8 being the farthest off; ' +
        '"normalize weights" divides them by their sum',
    ]);
  });

  it.each(['\n', '\r\n', '\r\r\n', '\r'])('are the same with lines that end in %j', async (end) => {
    const changed = Object.entries(contents).map(([name, bytes]) => {
      const lines = textOf(bytes as Uint8Array).split(/\r\r\n|\r\n|\r|\n/);
      return [name, lines.join(end)] as const;
    });
    expect(await readOne(Object.fromEntries(changed))).toEqual(character);
  });
});
