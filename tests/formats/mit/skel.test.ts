import { describe, expect, it } from 'vitest';
import { readSkel } from '../../../src/formats/mit/skel.ts';
import { bytesOf } from '../../support/files.ts';
import { courseSkel } from '../../support/course-skeleton.ts';
import { shown } from '../../support/diagnose.ts';

async function read(content: string | Uint8Array) {
  const { value, diagnostics } = await readSkel('a.skel', bytesOf(content));
  return { joints: value?.joints, messages: shown(diagnostics) };
}

const effect = 'the skeleton is not used';

describe('readSkel', () => {
  it('reads a joint a line, offsets relative to the parent', async () => {
    const { joints, messages } = await read('1 2 3 -1\n.5 -1e-3 +4. 0\n');
    expect(messages).toEqual([]);
    expect(joints).toMatchObject([
      { name: 'joint 00', place: { line: 1, column: 7 }, parent: -1, restOffset: [1, 2, 3] },
      { name: 'joint 01', place: { line: 2, column: 14 }, parent: 0, restOffset: [0.5, -0.001, 4] },
    ]);
  });

  it('gives the root three slides and every joint hinges about x, y, z', async () => {
    const { joints } = await read('0 0 0 -1\n0 0 0 0');
    const kinds = joints!.map(({ dofs }) => dofs.map(({ kind, axis }) => [kind, ...axis]));
    const hinges = [
      [1, 1, 0, 0],
      [1, 0, 1, 0],
      [1, 0, 0, 1],
    ];
    const slides = hinges.map(([, ...axis]) => [0, ...axis]);
    expect(kinds).toEqual([[...slides, ...hinges], hinges]);
  });

  it("gives the course's topology its names, another one numbers", async () => {
    expect((await read(courseSkel)).joints?.[3]?.name).toBe('Neck');
    expect((await read(`${courseSkel}0 0 0 17`)).joints?.[3]?.name).toBe('joint 03');
    const many = (await read('0 0 0 -1\n' + '0 0 0 0\n'.repeat(100))).joints;
    expect([many?.[3]?.name, many?.[100]?.name]).toEqual(['joint 003', 'joint 100']);
  });

  it('skips comments and blank lines, and accepts parents after their children', async () => {
    const { joints, messages } = await read('# two joints\n\n0 0 0 1 # child\n\n0 1 0 -1\n');
    expect(joints).toMatchObject([
      { place: { line: 3 }, parent: 1 },
      { place: { line: 5 }, parent: -1 },
    ]);
    expect(messages).toEqual([
      'warning: a.skel:5:7: expected the root to be the first joint, found "joint 1" [skel/root]; ' +
        'joint 0 still has no column of weights, as the format has it',
    ]);
  });

  it('accepts a forest, with a warning', async () => {
    const { joints, messages } = await read('0 0 0 -1\n0 0 0 -1');
    expect(joints).toHaveLength(2);
    expect(messages).toEqual([
      'warning: a.skel:2:7: expected one root (parent -1), found "2 roots" [skel/root]; ' +
        'they are read as a forest',
    ]);
  });

  it.each([
    ['0 0 0', '1: expected "tx ty tz parent", found "3 fields" [skel/field-count]'],
    ['0 0 0 -1\n0 0 0 0 0', '2: expected "tx ty tz parent", found "5 fields" [skel/field-count]'],
    ['nan 0 0 -1', '1:1: expected a number for x, found "nan" [skel/number]'],
    ['0 Infinity 0 -1', '1:3: expected a number for y, found "Infinity" [skel/number]'],
    ['0 0 0x10 -1', '1:5: expected a number for z, found "0x10" [skel/number]'],
    ['0 0,5 0 -1', '1:3: expected a number for y with a decimal point, found "0,5" [skel/number]'],
    ['0 0 1.2.3 -1', '1:5: expected a number for z, found "1.2.3" [skel/number]'],
    ['0 1e39 0 -1', '1:3: expected y within ±1e18, found "1e39" [skel/range]'],
    ['0 0 -1e400 -1', '1:5: expected z within ±1e18, found "-1e400" [skel/range]'],
    ['0 0 0 0.5', '1:7: expected -1 or the index of a joint, found "0.5" [skel/integer]'],
    ['0 0 0 -2', '1:7: expected -1 or the index of a joint, found "-2" [skel/integer]'],
  ])('refuses %j', async (text, message) => {
    expect(await read(text)).toEqual({
      joints: undefined,
      messages: [`error: a.skel:${message}; ${effect}`],
    });
  });

  it('names every bad field of a line', async () => {
    expect((await read('a b c d')).messages).toEqual([
      `error: a.skel:1:1: expected a number for x, found "a" [skel/number]; ${effect}`,
      `error: a.skel:1:3: expected a number for y, found "b" [skel/number]; ${effect}`,
      `error: a.skel:1:5: expected a number for z, found "c" [skel/number]; ${effect}`,
      `error: a.skel:1:7: expected -1 or the index of a joint, found "d" [skel/integer]; ${effect}`,
    ]);
  });

  it.each(['#\n', ' \n\t\n', '\uFEFF'])('finds no joint in %j', async (text) => {
    expect((await read(text)).messages).toEqual([
      `error: a.skel: expected at least one joint, found "none" [skel/empty]; ${effect}`,
    ]);
  });

  it('shows the line itself', async () => {
    const { diagnostics } = await readSkel('a.skel', bytesOf('0 0 0 -1\r\n0 x 0 0\r\n'));
    expect(diagnostics).toMatchObject([{ line: 2, column: 3, source: '0 x 0 0' }]);
  });
});
