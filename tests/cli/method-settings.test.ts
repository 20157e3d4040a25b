import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { UsageError } from '../../src/cli/usage-error.ts';
import { largestDifference } from '../support/compare.ts';
import { recordLines, runCommand } from './run-command.ts';

const files = {
  'a.skel': '0 0 0 -1\n0 1 0 0\n0 0 0 1\n',
  'a.obj': 'v 0 1 0\nv 0 2 0\nv 1 2 0\nf 1 2 3\n',
  'a.attach': '1 0\n0.5 0.5\n0.4 0.6\n',
  'p.json': '{"joints": {"#2": [0, 0, 2]}}',
};
const words = ['a.skel', 'a.obj', 'a.attach', '--pose', 'p.json', '--out', 'o.f32'];

recordLines();

async function posed(...options: string[]): Promise<Float32Array> {
  const { folder, code } = runCommand('pose', files, ...words, ...options);
  expect(await code).toBe(0);
  return new Float32Array(new Uint8Array(readFileSync(join(folder, 'o.f32'))).buffer);
}

it('takes long and short names of methods, and a value of a parameter', async () => {
  const linear = await posed();
  const dual = await posed('--method', 'dual-quaternion');
  expect(await posed('--method', 'dqs')).toEqual(dual);
  expect(largestDifference(linear, dual)).toBeGreaterThan(0.1);
  expect(await posed('--method', 'dqs', '--set', 'blend=0')).toEqual(linear);
  expect(await posed('--method', 'dqs', '--set', 'blend=1')).toEqual(dual);
  const half = await posed('--method', 'dqs', '--set', 'blend=0.5');
  const mean = linear.map((value, i) => (value + dual[i]!) / 2);
  expect(largestDifference(half, mean)).toBeLessThan(1e-6);
  // The last of several counts.
  expect(await posed('--method', 'dqs', '--set', 'blend=1', '--set', 'blend=0')).toEqual(linear);
});

it.each([
  [['dqs', 'blend=2'], 'expected --set blend from 0 to 1, found "2"'],
  [['dqs', 'blend=-0.1'], 'expected --set blend from 0 to 1, found "-0.1"'],
  [['dqs', 'blend=half'], 'expected --set blend from 0 to 1, found "half"'],
  [['dqs', 'blend='], 'expected --set blend from 0 to 1, found ""'],
  [['dqs', 'blend'], 'expected --set NAME=VALUE, found "blend"'],
  [['dqs', 'bland=0'], 'dual-quaternion has no "bland"; there is blend'],
  [['lbs', 'blend=0'], 'linear-blend has no "blend"; there is nothing to set'],
])('is used wrongly as --method %s', async ([method, set], message) => {
  const { code } = runCommand('pose', files, ...words, '--method', method!, '--set', set!);
  await expect(code).rejects.toThrow(new UsageError(message));
  await expect(code).rejects.toBeInstanceOf(UsageError);
});
