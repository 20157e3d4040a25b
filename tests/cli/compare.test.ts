import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { UsageError } from '../../src/cli/usage-error.ts';
import { methods } from '../../src/skinning/registry.ts';
import { recordLines, runCommand } from './run-command.ts';

const { errors, out } = recordLines();

/** Two joints with weights; the character is 2 high, and the third point is shared by both. */
const files = {
  'a.skel': '0 0 0 -1\n0 0 0 0\n0 1 0 1\n',
  'a.obj': 'v 0 0 0\nv 0 2 0\nv 1 2 0\nf 1 2 3\n',
  'a.attach': '1 0\n0 1\n0.4 0.6\n',
  'p.json': '{"joints": {"#2": [0, 0, 3.141592653589793]}}',
};
const names = ['a.skel', 'a.obj', 'a.attach'] as const;
const posed = [...names, '--pose', 'p.json'];

/** The table of a CSV: its rows by quantity and vertex, as texts by column. */
async function tableOf(contents: Record<string, string>, ...words: string[]) {
  const { folder, code } = runCommand('compare', contents, ...words, '--csv', 'o.csv');
  expect(await code).toBe(0);
  const text = readFileSync(join(folder, 'o.csv'), 'utf8');
  const [head, ...rows] = text
    .trimEnd()
    .split('\n')
    .map((line) => line.split(','));
  for (const row of rows) expect(row).toHaveLength(head!.length);
  const find = (quantity: string, vertex = ''): string[] | undefined =>
    rows.find((row) => row[0] === quantity && row[1] === vertex)?.slice(2);
  return { head, rows, find };
}

describe('compare', () => {
  // Joint 2 turns half around (0, 1): the third point goes to 0.4 (1, 2) + 0.6 (-1, 0), and by its
  // heaviest joint to (-1, 0), which is 0.4 (2, 2) away.
  const apart = 0.4 * Math.hypot(2, 2);

  it('prints how far methods are from the base, and their volumes', async () => {
    const { code } = runCommand('compare', files, ...posed, '--methods', 'lbs,rigid');
    expect(await code).toBe(0);
    const [head, base, rigid, ...others] = out.join('\n').split('\n');
    expect(head).toMatch(/^method +largest +of height +vertex +mean +of height +volume$/);
    expect(base).toMatch(/^lbs \(base\) +0 +0 % +– +0 +0 % +–$/);
    expect(rigid).toMatch(/^rigid +1\.131 +56\.6 % +#2 +0\.3771 +18\.9 % +–$/);
    expect(others).toEqual([]);
    expect(errors).toEqual([]);
  });

  it('writes one table with the numbers and the distance of each point', async () => {
    const { head, rows, find } = await tableOf(files, ...posed, '--methods', 'lbs,rigid');
    expect(head).toEqual(['quantity', 'vertex', 'lbs', 'rigid']);
    expect(rows.filter(([quantity]) => quantity === 'distance')).toHaveLength(3);
    expect(Number(find('distance', '2')![1])).toBeCloseTo(apart, 5);
    expect(Number(find('largest')![1])).toBeCloseTo(apart, 5);
    expect(Number(find('largest / height')![1])).toBeCloseTo(apart / 2, 5);
    expect(Number(find('largest / diagonal')![1])).toBeCloseTo(apart / Math.hypot(1, 2), 5);
    expect(Number(find('mean')![1])).toBeCloseTo(apart / 3, 5);
    expect(find('largest vertex')).toEqual(['', '2']);
    expect(find('volume / rest')).toEqual(['', '']);
    expect(find('largest by row sums')).toEqual(['', '']);
  });

  it('takes another base, long names and, without --methods, every method', async () => {
    const listed = ['--methods', 'linear-blend', '--base', 'rigid'];
    const { head, find } = await tableOf(files, ...posed, ...listed);
    expect(head).toEqual(['quantity', 'vertex', 'rigid', 'lbs']);
    expect(find('largest')![0]).toBe('0');
    expect(Number(find('largest')![1])).toBeCloseTo(apart, 5);
    const all = await tableOf(files, ...posed);
    expect(all.head!.slice(2)).toEqual(methods.map(({ short }) => short));
  });

  it('sets parameters of methods', async () => {
    const words = [...posed, '--methods', 'lbs,dqs', '--set'];
    const plain = await tableOf(files, ...words, 'blend=1');
    expect(Number(plain.find('largest')![1])).toBeGreaterThan(0.1);
    // At 0 the method is linear blend.
    const blended = await tableOf(files, ...words, 'blend=0');
    expect(Number(blended.find('largest')![1])).toBeLessThan(1e-6);
  });

  it('says which part is due to sums of rows, and divides them with --normalize', async () => {
    const odd = { ...files, 'a.attach': '1 0\n0 1\n0.4 0.5\n' };
    const { find } = await tableOf(odd, ...posed, '--methods', 'lbs');
    expect(Number(find('largest by row sums')![0])).toBeGreaterThan(0.01);
    expect(out.join('\n')).toContain('1 row of weights does not sum to 1, vertex #2');
    const divided = await tableOf(odd, ...posed, '--methods', 'lbs', '--normalize');
    expect(divided.find('largest by row sums')).toEqual(['']);
  });

  it.each([
    ['there are no files', [], 'expected files'],
    ['a method is unknown', [...posed, '--methods', 'lbs,xyz'], 'found "xyz"'],
    ['the base is unknown', [...posed, '--base', 'xyz'], 'found "xyz"'],
    ['a parameter is unknown', [...posed, '--set', 'xyz=1'], 'has no "xyz"'],
    ['a parameter is out of its range', [...posed, '--set', 'blend=7'], 'found "7"'],
    ['an option is unknown', [...posed, '--bases', 'lbs'], '--bases'],
  ])('is used incorrectly where %s', async (_, words, message) => {
    const run = runCommand('compare', files, ...words).code;
    await expect(run).rejects.toThrow(UsageError);
    await expect(run).rejects.toThrow(message);
  });

  it.each([
    ['the pose is not there', {}, 'q.json', 'q.json: expected a file that can be read'],
    ['there is no mesh', { 'a.obj': 'v 0 0 0' }, 'p.json', 'there is no mesh to pose'],
  ])('ends with 1 and writes nothing where %s', async (_, changed, pose, message) => {
    const words = [...names, '--pose', pose, '--csv', 'o.csv'];
    const { folder, code } = runCommand('compare', { ...files, ...changed }, ...words);
    expect(await code).toBe(1);
    expect(errors.join('\n')).toContain(message);
    expect(() => readFileSync(join(folder, 'o.csv'))).toThrow('ENOENT');
  });

  it('ends with 1 where the CSV cannot be written', async () => {
    const { code } = runCommand('compare', files, ...posed, '--csv', 'no/folder/o.csv');
    expect(await code).toBe(1);
    expect(errors.join('\n')).toContain('no/folder/o.csv: expected a file that can be written');
  });
});
