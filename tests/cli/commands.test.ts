import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { commands } from '../../src/cli/commands.ts';
import { unwritable } from '../../src/cli/files.ts';
import { UsageError } from '../../src/cli/usage-error.ts';
import { readObj } from '../../src/formats/obj/read-obj.ts';
import { kernels, normalWays } from '../../src/skinning/registry.ts';
import { leg, legAnim, legSkel, legSkin } from '../support/cse169-files.ts';
import { squarePmd } from '../support/pmd-files.ts';
import { zipOf } from '../support/zip.ts';
import { recordLines, runCommand } from './run-command.ts';

const files = {
  'a.skel': '0 0 0 -1\n0 1 0 0\n0 0 0 1\n',
  'a.obj': 'v 0 1 0\nv 0 2 0\nv 1 2 0\nusemtl skin\nf 1 2 3\n',
  'a.attach': '1 0\n0.5 0.25\n0.4 0.6\n',
  'p.json': '{"joints": {"#1": [0, 0, 3.141592653589793]}}',
};
const names = ['a.skel', 'a.obj', 'a.attach'] as const;

const { errors, out } = recordLines();

/** The posed points of the files above, rounded. */
async function posed(...options: string[]): Promise<number[]> {
  const { folder, code } = runCommand('pose', files, ...names, '--pose', 'p.json', ...options);
  expect(await code).toBe(0);
  const outPath = join(folder, options.at(-1)!);
  const read = await readObj('o.obj', new Uint8Array(readFileSync(outPath)));
  const mesh = read.value!;
  expect([...mesh.cornerPoints]).toEqual([0, 1, 2]);
  expect(mesh.submeshes).toEqual([{ material: 'skin', firstTriangle: 0 }]);
  return Array.from(mesh.positions, (value) => Math.round(value * 1e5) / 1e5 + 0);
}

describe('pose', () => {
  it('writes an OBJ with the faces and materials, weights as in the file', async () => {
    expect(await posed('--out', 'o.obj')).toEqual([0, 1, 0, 0, 0, 0, -1, 0, 0]);
    expect(errors).toHaveLength(1);
    expect(errors[0]).toContain('found "0.75 for 1"; they are used as they are, vertex 2');
  });

  it('divides weights by their sum with --normalize', async () => {
    // Both joints rotate alike, so that only the sum of the second row matters, in the translation.
    const raw = await posed('--out', 'raw.obj');
    const moved = { ...files, 'p.json': '{"root": [4, 0, 0]}' };
    const words = [...names, '--pose', 'p.json', '--normalize', '--out', 'o.obj'];
    const { folder, code } = runCommand('pose', moved, ...words);
    expect(await code).toBe(0);
    const text = readFileSync(join(folder, 'o.obj'), 'utf8');
    expect(text).toContain('v 4 1 0\nv 4 2 0\nv 5 2 0\n');
    expect(raw).toHaveLength(9);
  });

  it('takes every method of the registry', async () => {
    for (const { id } of kernels)
      expect(await posed('--method', id, '--out', 'o.obj')).toHaveLength(9);
  });

  it('writes the normals that --normals names, and none without it', async () => {
    const faces = async (...words: string[]): Promise<string[]> => {
      const all = ['--pose', 'p.json', ...words, '--out', 'o.obj'];
      const { folder, code } = runCommand('pose', files, ...names, ...all);
      expect(await code).toBe(0);
      return readFileSync(join(folder, 'o.obj'), 'utf8').match(/^(vn|f) .*$/gm)!;
    };
    expect(await faces()).toEqual(['f 1 2 3']);
    for (const { id } of normalWays) {
      const [normal, face] = await faces('--normals', id);
      expect(normal).toMatch(/^vn /);
      expect(face).toBe('f 1//1 2//1 3//1');
    }
    // The posed triangle is clockwise in the plane z = 0.
    expect(await faces('--normals', 'angle')).toContain('vn 0 0 -1');
  });

  it('keeps the strongest weights with --influences, and says what that moves', async () => {
    const pose = { 'p.json': '{"joints": {"#2": [0, 0, 3.141592653589793]}}' };
    const words = [...names, '--pose', 'p.json', '--out', 'o.obj', '--influences'];
    const positions = async (count: string): Promise<string[]> => {
      out.length = 0;
      const { folder, code } = runCommand('pose', { ...files, ...pose }, ...words, count);
      expect(await code).toBe(0);
      return readFileSync(join(folder, 'o.obj'), 'utf8').match(/^v .*$/gm)!;
    };
    // Joint 2 turns points half around (0, 1). The second point is the sum of 0.5 (0, 2) and
    // 0.25 (0, 0), or 0.75 (0, 2) alone; the third 0.4 (1, 2) + 0.6 (-1, 0), or (-1, 0) alone. With its
    // joints, the character is 2 high.
    const y = (lines: readonly string[]) => lines.map((line) => Number(line.split(' ')[2]));
    const alone = y(await positions('1'));
    [1, 1.5, 0].forEach((wanted, point) => expect(alone[point]).toBeCloseTo(wanted, 6));
    expect(out).toEqual([
      'At most 1.13 (57 % of the height), vertex #2\n' +
        '2 of 3 vertices move\n' +
        '0.544 (27 % of the height) in the mean of all',
    ]);
    const both = y(await positions('2'));
    [1, 1, 0.8].forEach((wanted, point) => expect(both[point]).toBeCloseTo(wanted, 6));
    expect(out).toEqual(['It moves no vertex in this pose']);
  });

  it('with --method rigid follows the heaviest joint alone', async () => {
    const pose = { 'p.json': '{"joints": {"#2": [0, 0, 3.141592653589793]}}' };
    const words = [...names, '--pose', 'p.json', '--method', 'rigid', '--out', 'o.obj'];
    const { folder, code } = runCommand('pose', { ...files, ...pose }, ...words);
    expect(await code).toBe(0);
    const text = readFileSync(join(folder, 'o.obj'), 'utf8');
    expect(text).toMatch(/^v 0 1 0\nv 0 2 0\nv -1 (0|[-\d.]+e-\d+) 0\n/);
  });

  it('keeps the left-handed space of a file with --keep-file-space, triangles too', async () => {
    const pose = '{"root":[0,0,5],"joints":{"#3":[0,0,0,1]}}';
    const contents = { 'a.pmd': squarePmd, 'p.json': pose };
    const words = ['a.pmd', '--pose', 'p.json', '--out', 'o.obj'];
    const text = async (...options: string[]): Promise<string> => {
      const { folder, code } = runCommand('pose', contents, ...words, ...options);
      expect(await code).toBe(0);
      return readFileSync(join(folder, 'o.obj'), 'utf8');
    };
    const faces = (obj: string): string[] =>
      obj.match(/^f .*$/gm)!.map((f) => f.replace(/\/\d+/g, ''));
    const inSinew = await text();
    expect(inSinew).toMatch(/^v -1 0 3\nv 1 0 3\nv 1 2 3\nv -1 2 3\n/);
    expect(faces(inSinew)).toEqual(['f 1 2 3', 'f 1 3 4']);
    const inFile = await text('--keep-file-space');
    expect(inFile).toMatch(/^v -1 0 -3\nv 1 0 -3\nv 1 2 -3\nv -1 2 -3\n/);
    expect(faces(inFile)).toEqual(['f 1 3 2', 'f 1 4 3']);
  });

  it('changes nothing with --keep-file-space where the file is right-handed', async () => {
    expect(await posed('--keep-file-space', '--out', 'o.obj')).toEqual(
      await posed('--out', 'o.obj'),
    );
  });

  it.each([
    ['the pose is not there', {}, 'q.json', 'q.json: expected a file that can be read'],
    ['the pose names no joint', { 'p.json': '{"joints":{"x":[0,0,0]}}' }, 'p.json', 'found "x"'],
    ['a file of the character is bad', { 'a.attach': '1\n1\n1' }, 'p.json', 'expected 2 weights'],
    ['there is no mesh', { 'a.obj': 'v 0 0 0' }, 'p.json', 'there is no mesh to pose'],
  ])('ends with 1 and writes nothing where %s', async (_, changed, pose, message) => {
    const words = [...names, '--pose', pose, '--out', 'o.obj'];
    const { folder, code } = runCommand('pose', { ...files, ...changed }, ...words);
    expect(await code).toBe(1);
    expect(errors.join('\n')).toContain(message);
    expect(() => readFileSync(join(folder, 'o.obj'))).toThrow('ENOENT');
  });

  it('has its own diagnostic code for files that cannot be written', () => {
    expect(unwritable('o.obj', new Error('full'))).toMatchObject({
      code: 'file/unwritable',
      file: 'o.obj',
      found: 'full',
    });
  });

  it('exits with 1 if it cannot write', async () => {
    const words = [...names, '--pose', 'p.json', '--out', 'no/such/folder/o.obj'];
    expect(await runCommand('pose', files, ...words).code).toBe(1);
    expect(errors).toContain(
      'error: no/such/folder/o.obj: expected a file that can be written, found "ENOENT"; ' +
        'nothing is written',
    );
  });

  it.each([
    [['--pose', 'p.json', '--out', 'o.obj'], 'expected files'],
    [[...names, '--out', 'o.obj'], 'expected --pose'],
    [[...names, '--pose', 'p.json'], 'expected --out'],
    [[...names, '--pose', 'p.json', '--out', 'o.txt'], 'ends in .obj or .f32'],
    [[...names, '--pose', 'p.json', '--method', 'x', '--out', 'o.obj'], 'found "x"'],
    [[...names, '--pose', 'p.json', '--influences', '0', '--out', 'o.obj'], 'found "0"'],
    [[...names, '--pose', 'p.json', '--influences', '1.5', '--out', 'o.obj'], 'found "1.5"'],
    [[...names, '--pose', 'p.json', '--bend', '--out', 'o.obj'], '--bend'],
    [[...names, 'p.json', '--out'], '--out'],
  ])('is used wrongly as %j', async (words, message) => {
    const { code } = runCommand('pose', files, ...words);
    await expect(code).rejects.toThrow(message);
    await expect(code).rejects.toBeInstanceOf(UsageError);
  });

  it('accepts the files of only one character', async () => {
    const two = { 'a.obj': files['a.obj'], 'b.obj': files['a.obj'], 'p.json': '{}' };
    const words = ['a.obj', 'b.obj', '--pose', 'p.json', '--out', 'o.obj'];
    await expect(runCommand('pose', two, ...words).code).rejects.toBeInstanceOf(UsageError);
  });
});

describe('info', () => {
  it('gives pose and limits as x, y, z, boxes, materials, morphs and clips', async () => {
    const contents = leg as Record<string, string>;
    expect(await runCommand('info', contents, ...Object.keys(contents), '--json').code).toBe(0);
    const { characters } = JSON.parse(out[0]!) as { characters: Record<string, unknown>[] };
    expect(characters[0]).toMatchObject({
      materials: [{ name: 'skin', texture: 'leg.bmp' }],
      morphs: [{ name: 'leg1', vertices: 2 }],
      clips: [{ name: 'leg_walk', start: 0, end: 2, channels: 12 }],
      missing: ['leg.bmp'],
    });
    const [hip] = characters[0]!['joints'] as unknown[];
    expect(hip).toMatchObject({
      pose: [0.5, 0, 0.25],
      limits: [[-1, 2], [0, 0], null],
      box: { min: [-0.1, -0.5, -0.1], max: [0.1, 0, 0.1] },
    });
  });

  it('gives bones with T and R, and their weights in sparse rows, with --bones', async () => {
    const contents = { 'a.pmd': squarePmd };
    expect(await runCommand('info', contents, 'a.pmd', '--bones', '--json').code).toBe(0);
    const { characters } = JSON.parse(out[0]!) as { characters: Record<string, unknown>[] };
    expect(characters[0]).toMatchObject({ fileSpace: 'left-handed' });
    const [first, second] = characters[0]!['bones'] as Record<string, unknown>[];
    expect(first).toMatchObject({ source: 0, destination: 1, parent: -1, vertices: [0, 1] });
    expect(first!['weights']).toEqual([1, 0.25]);
    expect(first!['length']).toBeCloseTo(Math.hypot(1, 0.5), 12);
    expect((first!['T'] as number[]).slice(12)).toEqual([0, 0, -2, 1]);
    // Joint 2 has no child, so its weights go to the bone that ends at it.
    expect(second).toMatchObject({ source: 1, destination: 2, parent: 0, vertices: [1, 2, 3] });
    expect((second!['T'] as number[])[12]).toBeCloseTo(Math.hypot(1, 0.5), 12);
    expect(second!['R']).toHaveLength(16);
    expect(await runCommand('info', contents, 'a.pmd', '--bones').code).toBe(0);
    expect(out[1]).toContain('  bone #0 to #1: length 1.118034, 2 vertices\n');
    expect(out[1]).not.toContain('bone #2 to #3');
  });

  it('names the joints and counts the rest', async () => {
    expect(await runCommand('info', files, ...names).code).toBe(0);
    expect(out).toEqual([
      'a: 3 joints, 3 vertices, 1 triangles, at most 2 influences\n' +
        '  #0 joint 00 (parent -1)\n  #1 joint 01 (parent 0)\n  #2 joint 02 (parent 1)',
    ]);
  });

  it('counts the vertices with more than four weights that are not zero', async () => {
    const joints = Array.from({ length: 6 }, (_, joint) => `0 1 0 ${joint - 1}\n`);
    const contents = {
      'a.skel': joints.join(''),
      'a.obj': files['a.obj'],
      'a.attach': '1 0 0 0 0\n0.2 0.2 0.2 0.2 0.2\n0.25 0.25 0.25 0 0.25\n',
    };
    expect(await runCommand('info', contents, ...names).code).toBe(0);
    expect(out[0]).toContain('at most 5 influences, more than 4 at 1 of the vertices\n');
  });

  it('exits with 0 if there is a character, and lists what is missing', async () => {
    expect(await runCommand('info', files, 'a.skel', 'p.json').code).toBe(0);
    expect(out[0]).toContain('without .obj, .attach');
    expect(errors[0]).toContain('warning: p.json: expected files that Sinew reads');
  });

  it('reads folders, with all that is in them, and archives', async () => {
    const { folder, code } = runCommand('info', { 'all.zip': zipOf(files) }, 'all.zip');
    expect(await code).toBe(0);
    expect(out[0]).toMatch(/^a: 3 joints, 3 vertices, 1 triangles/);
    mkdirSync(join(folder, 'x/y'), { recursive: true });
    for (const name of names) writeFileSync(join(folder, 'x/y', name), files[name]);
    writeFileSync(join(folder, 'x', '._a.obj'), 'junk');
    writeFileSync(join(folder, 'x', 'b.obj.gz'), gzipSync(files['a.obj']));
    expect(await commands[0]!.run(['x'])).toBe(0);
    expect(out.slice(1).map((text) => text.split(',')[0])).toEqual(['b: 0 joints', 'a: 3 joints']);
    expect(await commands[0]!.run(['x/y/a.obj', 'x/y/b', 'x/none'])).toBe(0);
    const missing = (path: string): string =>
      `error: ${path}: expected a file that can be read, found "ENOENT"; the file is not used`;
    expect(errors.slice(-2)).toEqual([missing('x/y/b'), missing('x/none')]);
  });

  it('reports an empty folder, and a .gz file that is not packed', async () => {
    const { folder, code } = runCommand('info', { 'a.obj.gz': 'no gzip' }, 'a.obj.gz');
    expect(await code).toBe(1);
    mkdirSync(join(folder, 'empty'));
    expect(await commands[0]!.run(['empty', 'a.obj.gz'])).toBe(1);
    expect(errors.join('\n')).toContain('empty: expected a file that can be read, found "an empty');
    expect(errors.join('\n')).toContain(
      'a.obj.gz: expected a file that can be read, found "Z_DATA',
    );
  });

  it('makes names from files safe to print', async () => {
    expect(await runCommand('info', {}, 'a\u001b[2J\u202e.skel').code).toBe(1);
    expect(errors.join('')).not.toMatch(/[\p{Cc}\p{Cf}]/u);
    const joined = { 'a\u202e.skel': files['a.skel'], 'b.obj': files['a.obj'] };
    expect(await runCommand('info', joined, ...Object.keys(joined)).code).toBe(0);
    expect(errors.join('')).not.toMatch(/[\p{Cc}\p{Cf}]/u);
    expect(out.join('').replaceAll('\n', '')).not.toMatch(/[\p{Cc}\p{Cf}]/u);
    expect(out[0]).toMatch(/^a\uFFFD: 3 joints/);
  });
});

describe('sample', () => {
  it('prints the values of a channel, counted from 0, before and after its keys too', async () => {
    const words = ['a.anim', '--channel', '1', '--times', '-1,0,1.5', '--json'];
    expect(await runCommand('sample', { 'a.anim': legAnim }, ...words).code).toBe(0);
    const { channel, times, values } = JSON.parse(out[0]!) as Record<string, unknown>;
    expect([channel, times]).toEqual([1, [-1, 0, 1.5]]);
    expect(values).toHaveLength(3);
    expect((values as number[]).slice(0, 2)).toEqual([0, 0.5]);
  });

  it.each([
    [['--channel', '0', '--times', '1'], 'expected one MOTION.json or .anim'],
    [['a.anim', '--times', '1'], 'expected --channel'],
    [['a.anim', '--channel', '', '--times', '1'], 'expected --channel'],
    [['a.anim', '--channel', '0'], 'expected --times'],
    [['a.anim', '--channel', '99', '--times', '1'], 'from 0 to 11'],
    [['a.anim', '--channel', 'knee.rx', '--times', '1'], 'the channels are #0.tx, #0.ty'],
  ])('is used wrongly as %j', async (words, message) => {
    const { code } = runCommand('sample', { 'a.anim': legAnim }, ...words);
    await expect(code).rejects.toThrow(message);
  });
});

describe('convert', () => {
  it("writes the other course's files and the matching pose, and says what is lost", async () => {
    const contents = {
      'a.skel': legSkel,
      'a.skin': legSkin,
      'p.json': '{"joints":{"knee":[1,0,9]}}',
    };
    const words = ['a.skel', 'a.skin', '--to', 'mit', '--out', 'new', '--pose', 'p.json'];
    const { folder, code } = runCommand('convert', contents, ...words);
    expect(await code).toBe(0);
    expect(out).toEqual(
      ['a.skel', 'a.obj', 'a.mtl', 'a.attach', 'p.json'].map((name) => join('new', name)),
    );
    expect(errors.join('\n')).toContain('z of "knee" from -2 to 2, found "9"');
    expect(errors.join('\n')).toContain('a root without weight is put before it');
    const pose = JSON.parse(readFileSync(join(folder, 'new/p.json'), 'utf8')) as { joints: object };
    expect(Object.keys(pose.joints)).toContain('joint 02');
  });

  it('writes a PMD and the matching pose, by quaternions', async () => {
    const words = [...names, '--to', 'pmd', '--out', 'new', '--pose', 'p.json'];
    const { folder, code } = runCommand('convert', files, ...words);
    expect(await code).toBe(0);
    expect(out).toEqual(['a.pmd', 'p.json'].map((name) => join('new', name)));
    expect(errors.join('\n')).toContain('a.pmd: expected materials without names');
    const pose = readFileSync(join(folder, 'new/p.json'), 'utf8');
    const { joints } = JSON.parse(pose) as { joints: Record<string, number[]> };
    expect(joints['joint 01']!.map((value) => Math.abs(Math.round(value * 1e9)))).toEqual([
      ...[0, 0, 1e9, 0],
    ]);
    const posing = ['new/a.pmd', '--pose', 'new/p.json', '--out', 'o.obj'];
    expect(await commands.find(({ name }) => name === 'pose')!.run(posing)).toBe(0);
  });

  it('exits with 1, and writes nothing, if the files can’t hold the character', async () => {
    const obj = `${'v 0 0 0\n'.repeat(65_536)}f 1 2 3\n`;
    const words = ['a.obj', '--to', 'pmd', '--out', 'new'];
    const { folder, code } = runCommand('convert', { 'a.obj': obj }, ...words);
    expect(await code).toBe(1);
    expect(out).toEqual([]);
    expect(errors.at(-1)).toContain('at most 65535 vertices');
    expect(existsSync(join(folder, 'new'))).toBe(false);
  });

  it.each([
    [['--to', 'mit', '--out', 'o'], 'expected files'],
    [['a.skel', '--to', 'pmx', '--out', 'o'], 'expected --to'],
    [['a.skel', '--to', 'mit'], 'expected --out'],
  ])('is used wrongly as %j', async (words, message) => {
    await expect(runCommand('convert', files, ...words).code).rejects.toThrow(message);
  });

  it('exits with 1 for a bad file', async () => {
    const words = ['a.skel', '--to', 'mit', '--out', 'o'];
    expect(await runCommand('convert', { 'a.skel': 'balljoint a {' }, ...words).code).toBe(1);
  });
});
