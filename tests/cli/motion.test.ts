import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { readAnim } from '../../src/formats/cse169/anim.ts';
import { readMotionText } from '../../src/formats/motion/read-motion.ts';
import { legAnim, legSkel, legSkin } from '../support/cse169-files.ts';
import { squarePmd } from '../support/pmd-files.ts';
import { recordLines, runCommand } from './run-command.ts';

const { errors, out } = recordLines();

const half = Math.SQRT1_2;
const wave = JSON.stringify({
  channels: [
    {
      target: { joint: 'Right elbow', value: 'rx' },
      keys: [
        [0, 1],
        [1, 3, 'linear', 'linear'],
      ],
    },
    {
      target: { joint: 'Neck', rotation: 'slerp' },
      keys: [
        [0, [0, 0, 0, 2]],
        [2, [1, 0, 0, 0]],
      ],
    },
    { target: { morph: 'smile' }, keys: [[0, 0.25]] },
    { target: { pin: 'Left foot', value: 'x' }, keys: [[0, 7]] },
    { target: { light: 'sun' }, keys: [] },
  ],
});

describe('sample of a MOTION.json', () => {
  async function sampled(channel: string, times: string): Promise<unknown> {
    const words = ['m.json', '--channel', channel, '--times', times, '--json'];
    expect(await runCommand('sample', { 'm.json': wave }, ...words).code).toBe(0);
    return (JSON.parse(out.at(-1)!) as { values: unknown }).values;
  }

  it('finds channels by name and by number, without a character', async () => {
    expect(await sampled('Right elbow.rx', '-1,0,1')).toEqual([1, 1, 3]);
    expect(await sampled('0', '-1,0,1')).toEqual([1, 1, 3]);
    for (const name of ['morph.smile', 'smile', '2'])
      expect(await sampled(name, '5')).toEqual([0.25]);
    for (const name of ['pin.Left foot.x', 'Left foot.x'])
      expect(await sampled(name, '5')).toEqual([7]);
  });

  it('prints rotations as x, y, z, w', async () => {
    for (const name of ['Neck', 'Neck.slerp', '1'])
      expect(await sampled(name, '2')).toEqual([[1, 0, 0, 0]]);
    const [at1] = (await sampled('Neck.rotation', '1')) as number[][];
    [half, 0, 0, half].forEach((part, i) => expect(at1![i]).toBeCloseTo(part, 12));
    await runCommand('sample', { 'm.json': wave }, 'm.json', '--channel', '1', '--times', '2').code;
    expect(out.at(-1)).toBe('2\t1,0,0,0');
    expect(errors[0]).toContain('expected a target that Sinew knows, found "light"');
  });

  it('keeps the channel as it was asked for', async () => {
    const words = ['m.json', '--channel', 'smile', '--times', '0', '--json'];
    await runCommand('sample', { 'm.json': wave }, ...words).code;
    expect(JSON.parse(out[0]!)).toEqual({ channel: 'smile', times: [0], values: [0.25] });
  });

  it('counts channels as the file does, with those that cannot be used and with doubles', async () => {
    const morph = (value: number) => ({ target: { morph: 'smile' }, keys: [[0, value]] });
    const channels = [{ target: { light: 'sun' }, keys: [] }, morph(1), morph(2)];
    const contents = { 'm.json': JSON.stringify({ channels }) };
    for (const [channel, value] of [
      ['1', 1],
      ['2', 2],
      ['smile', 2],
    ] as const) {
      const words = ['m.json', '--channel', channel, '--times', '0'];
      expect(await runCommand('sample', contents, ...words).code).toBe(0);
      expect(out.at(-1)).toBe(`0\t${value}`);
    }
    for (const channel of ['3', '-1']) {
      const words = ['m.json', '--channel', channel, '--times', '0'];
      await expect(runCommand('sample', contents, ...words).code).rejects.toThrow(
        'expected --channel from 0 to 2 or a name',
      );
    }
  });

  it('ends with 1 where the file is to blame for a channel that cannot be used', async () => {
    const channels = [{ target: { light: 'sun' }, keys: [] }];
    for (const [contents, channel, message] of [
      [{ channels }, '0', 'error: channel 0 cannot be used'],
      [{ channels }, 'sun', 'error: no channel of the motion can be used'],
      [{ channels: [] }, '0', 'error: the motion has no channels'],
    ] as const) {
      const words = ['m.json', '--channel', channel, '--times', '0'];
      const files = { 'm.json': JSON.stringify(contents) };
      expect(await runCommand('sample', files, ...words).code).toBe(1);
      expect(errors.at(-1)).toBe(message);
    }
  });

  it('lists the channels when one is not there', async () => {
    const words = ['m.json', '--channel', 'elbow.rx', '--times', '0'];
    await expect(runCommand('sample', { 'm.json': wave }, ...words).code).rejects.toThrow(
      'expected --channel from 0 to 4 or a name, found "elbow.rx"; the channels are Right elbow.rx, Neck.rotation, morph.smile, pin.Left foot.x',
    );
  });

  it('ends with 1 where there is no motion', async () => {
    const words = ['--channel', '0', '--times', '0'];
    expect(await runCommand('sample', { 'm.json': '{}' }, 'm.json', ...words).code).toBe(1);
    expect(await runCommand('sample', {}, 'none.json', ...words).code).toBe(1);
    expect(errors.join()).toContain('found "ENOENT"');
  });
});

const leg = { 'a.skel': legSkel, 'a.skin': legSkin };
const kneeMotion = JSON.stringify({
  range: [0, 1],
  channels: [
    {
      target: { joint: 'knee', value: 'rx' },
      extrapolate: ['constant', 'linear'],
      keys: [
        [0, 0],
        [1, 1, 'linear', 'linear'],
      ],
    },
  ],
});

describe('pose with a motion', () => {
  async function posed(...words: string[]): Promise<string> {
    const contents = {
      ...leg,
      'm.json': kneeMotion,
      'a.anim': legAnim,
      'still.json': '{"joints":{"knee":[0.5,-0.25,0.75],"hip":[0.5,0,0.25]}}',
      'bent.json': '{"joints":{"knee":[0.5,-0.25,0.75],"foot":[1,0,0]}}',
      'foot.json': '{"joints":{"foot":[1,0,0]}}',
    };
    const { folder, code } = runCommand(
      'pose',
      contents,
      'a.skel',
      'a.skin',
      ...words,
      '--out',
      'o.obj',
    );
    expect(await code).toBe(0);
    return readFileSync(join(folder, 'o.obj'), 'utf8');
  }

  it('shows what the motion moves at the time, over the pose', async () => {
    const at = ['--motion', 'm.json', '--time', '0.5'];
    expect(await posed(...at)).toBe(await posed('--pose', 'still.json'));
    expect(await posed('--pose', 'foot.json', ...at)).toBe(await posed('--pose', 'bent.json'));
  });

  it('continues outside the range', async () => {
    const later = await posed('--motion', 'm.json', '--time', '1.5');
    expect(later).not.toBe(await posed('--motion', 'm.json', '--time', '1'));
    const before = await posed('--motion', 'm.json', '--time', '-3');
    expect(before).toBe(await posed('--motion', 'm.json', '--time', '0'));
  });

  it('takes an .anim', async () => {
    const [a, b] = [
      await posed('--motion', 'a.anim', '--time', '0'),
      await posed('--motion', 'a.anim', '--time', '1'),
    ];
    expect(a).not.toBe(b);
  });

  it.each([
    [['--out', 'o.obj'], 'expected --pose POSE.json or POSE.vpd, or --motion with --time'],
    [['--motion', 'm.json', '--out', 'o.obj'], 'expected --motion and --time together'],
    [
      ['--pose', 'p.json', '--time', '1', '--out', 'o.obj'],
      'expected --motion and --time together',
    ],
    [
      ['--motion', 'm.json', '--time', 'x', '--out', 'o.obj'],
      'expected --time in seconds, found "x"',
    ],
  ])('is used wrongly as %j', async (words, message) => {
    await expect(runCommand('pose', leg, 'a.skel', 'a.skin', ...words).code).rejects.toThrow(
      message,
    );
  });

  it('ends with 1 where a channel is wrong', async () => {
    const wrong = kneeMotion.replace('knee', 'elbow');
    const words = ['a.skel', 'a.skin', '--motion', 'm.json', '--time', '0', '--out', 'o.obj'];
    expect(await runCommand('pose', { ...leg, 'm.json': wrong }, ...words).code).toBe(1);
    expect(errors.join()).toContain('found "elbow"');
    expect(errors.at(-1)).toBe('error: nothing is written, because the motion has errors');
  });

  it('writes with defaults for a rate and a range that cannot be used', async () => {
    const wrong = kneeMotion.replace('[0,1]', '"all"').replace('{', '{"fps":0,');
    const words = ['a.skel', 'a.skin', '--motion', 'm.json', '--time', '0', '--out', 'o.obj'];
    expect(await runCommand('pose', { ...leg, 'm.json': wrong }, ...words).code).toBe(0);
    const own = errors.filter((line) => line.includes('m.json'));
    expect(own).toHaveLength(2);
    expect(own[0]).toMatch(/^warning: m.json:1:8 \(fps\): .*; 30 are used$/);
  });

  it('says where an incomplete pin is', async () => {
    const channels = [{ target: { pin: 'foot', value: 'x' }, keys: [[0, 1]] }];
    const files = { ...leg, 'm.json': JSON.stringify({ channels }) };
    const words = ['a.skel', 'a.skin', '--motion', 'm.json', '--time', '0', '--out', 'o.obj'];
    expect(await runCommand('pose', files, ...words).code).toBe(0);
    expect(errors.join()).toContain('m.json:1:31 (channels[0].target.pin): expected a pin at');
  });
});

describe('convert with a motion', () => {
  it('writes nothing where a channel is wrong', async () => {
    const files = { ...leg, 'm.json': kneeMotion.replace('knee', 'elbow') };
    const words = ['a.skel', 'a.skin', '--to', 'cse169', '--out', 'new', '--motion', 'm.json'];
    expect(await runCommand('convert', files, ...words).code).toBe(1);
    expect(errors.at(-1)).toBe('error: nothing is written, because the motion has errors');
  });

  async function converted(to: string, motion: string, name = 'bend.motion.json', extra = {}) {
    const contents = { ...leg, ...extra, [name]: motion };
    const words = ['a.skel', 'a.skin', '--to', to, '--out', 'new', '--motion', name];
    const { folder, code } = runCommand('convert', contents, ...words);
    return { code: await code, read: (file: string) => readFileSync(join(folder, 'new', file)) };
  }

  it('writes an .anim for CSE169, with losses', async () => {
    const { code, read } = await converted('cse169', kneeMotion);
    expect(code).toBe(0);
    const { value } = readAnim('bend.anim', read('bend.anim'));
    expect(value!.channels[6]!.keys.map(({ value: angle }) => angle)).toEqual([0, 1]);
    expect(errors.join('\n')).toContain('they are fixed slopes');
  });

  it("writes a MOTION.json of the same turns in the other course's order", async () => {
    const { code, read } = await converted('mit', legAnim, 'walk.anim');
    expect(code).toBe(0);
    const { value, diagnostics } = readMotionText('walk', read('walk.motion.json').toString());
    expect(diagnostics).toEqual([]);
    expect(value!.channels.length).toBeGreaterThan(0);
    expect(errors.join('\n')).toMatch(
      /sampled at 30 frames a second and solved again; off by at most [\d.e-]+°/,
    );
  });

  it('writes rotations for a PMD', async () => {
    const { code, read } = await converted('pmd', kneeMotion);
    expect(code).toBe(0);
    const { value } = readMotionText('m', read('bend.motion.json').toString());
    expect(value!.channels.map(({ curve }) => curve.of)).toEqual(['rotation']);
  });

  it('writes a MOTION.json beside files of the same format', async () => {
    const contents = { 'a.pmd': squarePmd, 'm.json': '{"channels":[]}' };
    const words = ['a.pmd', '--to', 'pmd', '--out', 'new', '--motion', 'm.json'];
    expect(await runCommand('convert', contents, ...words).code).toBe(0);
    expect(out.some((line) => line.endsWith('m.motion.json'))).toBe(true);
  });
});
