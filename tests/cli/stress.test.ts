import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { UsageError } from '../../src/cli/usage-error.ts';
import { recordLines, runCommand } from './run-command.ts';

const { errors, out } = recordLines();

/** Two joints with weights; the character is 2 high, and the outer points are shared by both. */
const files = {
  'a.skel': '0 0 0 -1\n0 0 0 0\n0 1 0 1\n',
  'a.obj': 'v 0 0 0\nv 0 2 0\nv 1 2 0\nv -1 2 0\nf 1 2 3\nf 1 4 2\n',
  'a.attach': '1 0\n0 1\n0.4 0.6\n0.4 0.6\n',
};
const names = ['a.skel', 'a.obj', 'a.attach'] as const;

/** The rows of a CSV that a command writes, each as texts. */
async function tableOf(command: string, contents: Record<string, string>, ...words: string[]) {
  const { folder, code } = runCommand(command, contents, ...words, '--csv', 'o.csv');
  expect(await code).toBe(0);
  const lines = readFileSync(join(folder, 'o.csv'), 'utf8').trimEnd().split('\n');
  return lines.map((line) => line.split(','));
}

describe('stress', () => {
  it('prints the differences and volumes of every pose, and the largest', async () => {
    const { code } = runCommand('stress', files, ...names, '--methods', 'lbs,rigid');
    expect(await code).toBe(0);
    const [head, ...rows] = out.join('\n').split('\n');
    expect(head).toMatch(/^pose +rigid largest +rigid mean +lbs volume +rigid volume$/);
    expect(rows).toHaveLength(7);
    expect(rows[0]).toMatch(/^joint 02 · bend 120° +\d.* % +\d.* % +– +–$/);
    expect(rows[6]).toMatch(/^6 poses; differences from lbs .*, at joint 02 · (bend|side) −?120°$/);
    expect(errors).toEqual([]);
  });

  it('writes the numbers that compare gives in the same pose', async () => {
    const words = [...names, '--methods', 'lbs,rigid,dqs', '--base', 'rigid'];
    const [head, ...rows] = await tableOf('stress', files, ...words);
    for (const row of rows) expect(row).toHaveLength(head!.length);
    const twist = rows.find((row) => row[1] === 'twist' && row[2] === '90')!;
    const posed = { ...files, 'p.json': `{"joints": {"#2": [0, ${Math.PI / 2}, 0]}}` };
    const compared = await tableOf('compare', posed, ...words, '--pose', 'p.json');
    for (const quantity of ['largest', 'largest / height', 'mean', 'mean / height']) {
      const expected = compared.find(([name]) => name === quantity)!.slice(2);
      const found = ['lbs', 'rigid', 'dqs'].map((short) => {
        return twist[head!.indexOf(`${short} ${quantity}`)];
      });
      expect(found).toEqual(expected);
    }
  });

  it('turns joints as far as it is told, from another pose', async () => {
    const words = [...names, '--bend', '30', '--twist', '60', '--pose', 'p.json'];
    const posed = { ...files, 'p.json': '{"joints": {"#1": [0, 0, 1]}}' };
    const rows = await tableOf('stress', posed, ...words, '--methods', 'lbs,rigid');
    expect(rows.slice(1).map(([, motion, degrees]) => `${motion} ${degrees}`)).toEqual([
      ...['bend 30', 'bend -30', 'side 30', 'side -30', 'twist 60', 'twist -60'],
    ]);
  });

  it('says so where no joint deforms the mesh', async () => {
    const whole = { ...files, 'a.attach': '0 1\n0 1\n0 1\n0 1\n' };
    expect(await runCommand('stress', whole, ...names).code).toBe(0);
    expect(out).toEqual(['No joint deforms the mesh.']);
  });

  it.each([
    ['there are no files', [], 'expected files'],
    ['a method is unknown', [...names, '--methods', 'lbs,xyz'], 'found "xyz"'],
    ['the base is unknown', [...names, '--base', 'xyz'], 'found "xyz"'],
    ['a range is negative', [...names, '--bend', '-3'], 'expected --bend in degrees'],
    ['a range is more than half a turn', [...names, '--twist', '181'], 'found "181"'],
    ['a range is no number', [...names, '--twist', 'far'], 'found "far"'],
    ['an option is unknown', [...names, '--bends', '3'], '--bends'],
  ])('is used incorrectly where %s', async (_, words, message) => {
    const run = runCommand('stress', files, ...words).code;
    await expect(run).rejects.toThrow(UsageError);
    await expect(run).rejects.toThrow(message);
  });

  it('ends with 1 where there is no mesh or the CSV cannot be written', async () => {
    expect(await runCommand('stress', { 'a.skel': files['a.skel'] }, ...names).code).toBe(1);
    expect(errors.join('\n')).toContain('there is no mesh to pose');
    const words = [...names, '--methods', 'lbs,rigid', '--csv', 'no/folder/o.csv'];
    expect(await runCommand('stress', files, ...words).code).toBe(1);
    expect(errors.join('\n')).toContain('no/folder/o.csv: expected a file that can be written');
  });
});
