import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { UsageError } from '../../src/cli/usage-error.ts';
import { recordLines, runCommand } from './run-command.ts';

const { errors, out } = recordLines();

const ring = [
  [1, 1],
  [-1, 1],
  [-1, -1],
  [1, -1],
] as const;
const floors = [0, 1, 2, 3];
/** A square prism along y with a joint at half its height, whose weights change from 0 to 1. */
const files = {
  'a.skel': '0 0 0 -1\n0 0 0 0\n0 1.5 0 1\n',
  'a.obj': [
    ...floors.flatMap((y) => ring.map(([x, z]) => `v ${x} ${y} ${z}`)),
    ...floors.slice(1).flatMap((y) =>
      ring.map((_, side) => {
        const [a, b] = [y * 4 + side + 1, y * 4 + ((side + 1) % 4) + 1];
        return `f ${a} ${a - 4} ${b - 4} ${b}`;
      }),
    ),
    'f 4 3 2 1',
    'f 13 14 15 16',
    '',
  ].join('\n'),
  'a.attach': floors.map((y) => ring.map(() => `${1 - y / 3} ${y / 3}\n`).join('')).join(''),
};
const names = ['a.skel', 'a.obj', 'a.attach'] as const;
const twist = [...names, '--joint', '#2', '--axis', 'y'];

describe('sweep', () => {
  it('prints volume and section of each method over the range', async () => {
    const words = [...twist, '--steps', '4', '--methods', 'lbs,rigid'];
    expect(await runCommand('sweep', files, ...words).code).toBe(0);
    const [head, ...rows] = out.join('\n').split('\n');
    expect(head).toMatch(/^degrees +lbs volume +rigid volume +lbs section +rigid section$/);
    expect(rows.map((row) => row.split(/ +/)[0])).toEqual(['-180°', '-90°', '0°', '90°', '180°']);
    expect(rows[2]).toMatch(/^0° +100\.0 % +100\.0 % +100\.0 % +100\.0 %$/);
    // Half a turn collapses the middle.
    expect(rows[4]).toMatch(/^180° .* 0\.0 % +\d/);
    expect(errors).toEqual([]);
  });

  it('writes the same numbers as a table', async () => {
    const words = [...twist, '--steps', '2', '--methods', 'lbs', '--csv', 'o.csv'];
    const { folder, code } = runCommand('sweep', files, ...words);
    expect(await code).toBe(0);
    const lines = readFileSync(join(folder, 'o.csv'), 'utf8').trimEnd().split('\n');
    expect(lines[0]).toBe('degrees,lbs volume / rest,lbs section / rest');
    expect(lines[2]).toBe('0,1,1');
    expect(lines).toHaveLength(4);
  });

  it('gives parameters of methods values', async () => {
    const blended = async (blend: string) => {
      const words = [...twist, '--steps', '2', '--methods', 'dqs', '--set', `blend=${blend}`];
      expect(await runCommand('sweep', files, ...words).code).toBe(0);
      const [head, first] = out.splice(0).join('\n').split('\n');
      expect(head).toMatch(/^degrees +dqs volume/);
      return Number(/^-180° +(\S+) %/.exec(first!)![1]);
    };
    expect(await blended('0')).toBeLessThan((await blended('1')) - 20);
  });

  it.each([
    ['there are no files', ['--joint', '#2', '--axis', 'x'], 'expected files'],
    ['no joint is named', [...names, '--axis', 'x'], 'expected --joint'],
    ['the joint is unknown', [...names, '--joint', 'knee', '--axis', 'x'], 'found "knee"'],
    ['the axis is unknown', [...names, '--joint', '#2', '--axis', 'w'], 'found "w"'],
    ['there are no steps', [...twist, '--steps', '-3'], 'found "-3"'],
    ['the joint cannot turn about it', [...names, '--joint', '#9', '--axis', 'x'], 'found "#9"'],
    ['a parameter is unknown', [...twist, '--set', 'bend=1'], 'has no "bend"; there is blend'],
    ['a value is too large', [...twist, '--set', 'blend=2'], 'from 0 to 1, found "2"'],
    ['a method is unknown', [...twist, '--methods', 'xyz'], 'found "xyz"'],
  ])('is used incorrectly where %s', async (_, words, message) => {
    const run = runCommand('sweep', files, ...words).code;
    await expect(run).rejects.toThrow(UsageError);
    await expect(run).rejects.toThrow(message);
  });

  it('ends with 1 where there is no mesh', async () => {
    expect(await runCommand('sweep', { 'a.skel': files['a.skel'] }, ...twist).code).toBe(1);
    expect(errors.join('\n')).toContain('there is no mesh to pose');
  });
});
