import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { describe, it } from 'vitest';
import { commands } from '../../src/cli/commands.ts';
import { readOne } from '../support/files.ts';
import { golden, oddities } from '../support/golden.ts';
import { folderWith, runSinew } from './run-sinew.ts';

const skel = '0 0 0 -1\n0 1 0 0\n';
const obj = 'v 0 1 0\nv 0 2 0\nv 1 2 0\nv 0 0 0\nf 1 2 3\n';
const attach = '1\n1\n0.5\n0\n';
const arm = { 'a.skel': skel, 'a.obj': obj, 'a.attach': attach };
const turned = { 'p.json': '{"root": [0, 0, 3], "joints": {"#1": [0, 0, 1.5707963267948966]}}' };

function floatsOf(path: string): number[] {
  const { buffer, byteOffset, byteLength } = readFileSync(path);
  const view = new DataView(buffer, byteOffset, byteLength);
  return Array.from({ length: view.byteLength / 4 }, (_, i) => view.getFloat32(i * 4, true));
}

// Each test starts a process and takes about a second, so these run in parallel. The other files of
// this folder test most of the command line without a process.
describe.concurrent('sinew, as a process', () => {
  it('poses to .f32: points in file order, little-endian, raw weights', async ({
    expect,
    onTestFinished,
  }) => {
    const folder = folderWith({ ...arm, ...turned }, onTestFinished);
    const files = ['a.attach', 'a.skel', 'a.obj'];
    const ending = await runSinew(folder, 'pose', ...files, '--pose', 'p.json', '--out', 'o.f32');
    expect(ending).toMatchObject({ code: 0, out: '' });
    expect(ending.errors.trimEnd().split('\n')).toHaveLength(2);
    expect(ending.errors).toMatch(/^warning: a\.attach:\d+: expected .+, found ".+"; .+$/m);
    const posed = floatsOf(join(folder, 'o.f32'));
    const expected = [0, 1, 3, -1, 1, 3, -0.5, 1, 1.5, 0, 0, 3];
    expect(posed).toHaveLength(expected.length);
    posed.forEach((value, i) => expect(value).toBeCloseTo(expected[i]!, 6));
  });

  it('lists the content of files as JSON, also of packed ones', async ({
    expect,
    onTestFinished,
  }) => {
    const contents = golden(...oddities);
    const packed = gzipSync(contents['oddities.obj'] as Uint8Array);
    const folder = folderWith({ ...contents, 'oddities.obj.gz': packed }, onTestFinished);
    const files = ['oddities.skel', 'oddities.obj.gz', 'oddities.attach'];
    const { code, out } = await runSinew(folder, 'info', ...files, '--json');
    expect(code).toBe(0);
    const { characters, diagnostics } = JSON.parse(out) as Record<string, unknown[]>;
    const { skeleton } = await readOne(contents);
    expect(skeleton.jointCount).toBe(3);
    expect(diagnostics).toHaveLength(5);
    expect(characters).toMatchObject([
      {
        name: 'oddities',
        missing: [],
        vertices: 9,
        triangles: 5,
        largestInfluenceCount: 2,
        verticesOverFourInfluences: 0,
        joints: [
          { index: 0, name: 'joint 00', parent: 2, offset: [0, 1, 0] },
          { index: 1, parent: 0 },
          { index: 2, parent: -1, offset: [0.1, 0.25, 3] },
        ],
      },
    ]);
  });

  it('exits with 1 and prints a line for each problem of a bad file', async ({
    expect,
    onTestFinished,
  }) => {
    const folder = folderWith({ ...turned, 'a.skel': '0 0 x -1\n0 0 0\n' }, onTestFinished);
    const ending = await runSinew(folder, 'info', 'a.skel', 'none.obj');
    expect(ending).toEqual({
      code: 1,
      out: '',
      errors:
        'error: none.obj: expected a file that can be read, found "ENOENT"; the file is not used\n' +
        'error: a.skel:1:5: expected a number for z, found "x"; the skeleton is not used\n' +
        'error: a.skel:2: expected "tx ty tz parent", found "3 fields"; the skeleton is not used\n',
    });
  });

  it('lists every command and what it does', async ({ expect }) => {
    const { code, out, errors } = await runSinew('.', 'help');
    expect({ code, errors }).toEqual({ code: 0, errors: '' });
    for (const { usage, summary } of commands) {
      expect(out).toContain(`  sinew ${usage}\n      ${summary}\n`);
    }
  });

  it('prints what one command takes', async ({ expect }) => {
    for (const words of [
      ['stress', 'a.skel', '--help'],
      ['help', 'stress'],
    ]) {
      const { code, out, errors } = await runSinew('.', ...words);
      expect({ code, errors }).toEqual({ code: 0, errors: '' });
      expect(out).toContain('Usage:\n  sinew stress FILES');
      expect(out.match(/^ {2}sinew /gm)).toHaveLength(1);
    }
  });

  it('exits with 2 and prints the usage for wrong usage', async ({ expect }) => {
    const { code, out, errors } = await runSinew('.', 'bend', 'a.skel');
    expect({ code, out }).toEqual({ code: 2, out: '' });
    expect(errors).toMatch(/^expected a command, found "bend"\nUsage:\n {2}sinew info FILES/);
  });
});
