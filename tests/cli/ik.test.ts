import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { UsageError } from '../../src/cli/usage-error.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { readPoseJson } from '../../src/formats/read-pose-json.ts';
import { readOne } from '../support/files.ts';
import { recordLines, runCommand } from './run-command.ts';

const skel = '0 0 0 -1\n0 1 0 0\n0 1 0 1\n0 1 0 2\n';

/** A joint with a link of length 1 that turns about z, and a second link that bends one way. */
const arm = {
  order: 'RzRyRx',
  joints: [
    { offset: [0, 0, 0], parent: -1, note: 'ignored' },
    { offset: [1, 0, 0], parent: 0 },
  ],
  dofs: [
    { joint: 1, axis: 'z', min: 0, max: 2.5 },
    { joint: 0, axis: 'z', min: -3, max: 3 },
  ],
  effectors: [{ joint: 1, local: [1, 0, 0], target: [1, 1, 0] }],
};

const { errors, out } = recordLines();

function run(contents: Record<string, string>, ...words: string[]) {
  return runCommand('ik', contents, ...words);
}

interface Answer {
  readonly angles: readonly number[];
  readonly residuals: readonly number[];
  readonly iterations: number;
  readonly status: string;
}

async function answerOf(problem: unknown, ...words: string[]): Promise<Answer> {
  const { code } = run({ 'p.json': JSON.stringify(problem) }, 'p.json', '--json', ...words);
  expect(await code).toBe(0);
  return JSON.parse(out.join('\n')) as Answer;
}

describe('ik of a problem', () => {
  it.each(['dls', 'ccd', 'fabrik'])(
    'prints angles in the order of its dofs: %s',
    async (method) => {
      const { angles, residuals, status } = await answerOf(arm, '--method', method);
      const [elbow, shoulder] = angles as [number, number];
      expect(status).toBe('reached');
      expect(elbow).toBeGreaterThanOrEqual(0);
      const x = Math.cos(shoulder) + Math.cos(shoulder + elbow);
      const y = Math.sin(shoulder) + Math.sin(shoulder + elbow);
      const apart = Math.hypot(x - 1, y - 1);
      expect(apart).toBeLessThan(2e-3);
      expect(residuals[0]).toBeCloseTo(apart, 9);
    },
  );

  it.each([
    [{ target: [5, 0, 0] }, 'out-of-reach'],
    [{ target: [1, 1, 0], local: [0.5, 0, 0] }, 'reached'],
    // The elbow's limit of 2.5 leaves a hole around the shoulder.
    [{ target: [0.1, 0, 0] }, 'limits'],
  ])('says how it ended: %j', async (effector, status) => {
    const problem = { ...arm, effectors: [{ ...arm.effectors[0], ...effector }] };
    expect((await answerOf(problem)).status).toBe(status);
  });

  it('is stalled where neither reach nor limits explain the residual', async () => {
    const dofs = arm.dofs.map(({ joint, axis }) => ({ joint, axis }));
    const joints = [arm.joints[0], { offset: [2, 0, 0], parent: 0 }];
    const effectors = [{ joint: 1, local: [1, 0, 0], target: [0.5, 0, 0] }];
    const answer = await answerOf({ ...arm, joints, dofs, effectors });
    expect(answer.status).toBe('stalled');
    expect(answer.residuals[0]).toBeCloseTo(0.5, 6);
  });

  it('multiplies rotations in the given order', async () => {
    const dofs = ['x', 'y', 'z'].map((axis) => ({ joint: 0, axis }));
    const joints = [{ offset: [0, 0, 0], parent: -1 }];
    const effectors = [
      { joint: 0, local: [1, 0, 0], target: [0.6, 0.48, -0.64] },
      { joint: 0, local: [0, 1, 0], target: [-0.8, 0.36, -0.48] },
    ];
    for (const [order, first] of [
      ['RxRyRz', 2],
      ['RzRyRx', 0],
    ] as const) {
      out.length = 0;
      const { angles, status } = await answerOf({ order, joints, dofs, effectors });
      expect(status).toBe('reached');
      const turned = [1, 0, 0];
      for (const axis of first === 2 ? [2, 1, 0] : [0, 1, 2]) rotate(turned, axis, angles[axis]!);
      turned.forEach((value, i) => expect(value).toBeCloseTo([0.6, 0.48, -0.64][i]!, 4));
    }
  });

  it('answers a list with a list, whether it has a name or not', async () => {
    for (const contents of [[arm, arm], { problems: [arm, arm], note: 'two' }]) {
      out.length = 0;
      const { code } = run({ 'p.json': JSON.stringify(contents) }, 'p.json', '--json');
      expect(await code).toBe(0);
      const answers = JSON.parse(out.join('')) as Answer[];
      expect(answers).toHaveLength(2);
      expect(answers[1]).toEqual(answers[0]);
    }
  });

  it.each([
    ['text', '{"joints": [}', 'p.json:1:13 (joints[0]): expected a value, found "}"'],
    ['order', { order: 'RyRxRz' }, '(order): expected "order" to be "RxRyRz" or "RzRyRx"'],
    ['offset', { joints: [{ offset: [0, 0], parent: -1 }] }, '(joints[0].offset): expected three'],
    ['roots', { joints: arm.joints.map((each) => ({ ...each, parent: 0 })) }, 'at least one root'],
    ['joint', { dofs: [{ joint: 7, axis: 'z' }] }, '(dofs[0].joint): expected a whole number'],
    ['axis', { dofs: [{ joint: 0, axis: 'w' }] }, '(dofs[0].axis): expected "axis" to be'],
    ['limits', { dofs: [{ joint: 0, axis: 'z', min: 1, max: 0 }] }, '(dofs[0].max): expected'],
    ['duplicate', { dofs: [arm.dofs[0], arm.dofs[0]] }, '(dofs[1]): expected each axis of a joint'],
    ['target', { effectors: [{ joint: 0, local: [0, 0, 0] }] }, '(effectors[0].target): expected'],
    ['effectors', { effectors: undefined }, '(effectors): expected a list of effectors'],
    ['shape', '3', 'expected a problem with "joints", "dofs" and "effectors", found "3"'],
  ])('refuses a bad %s', async (_, change, message) => {
    const text = typeof change === 'string' ? change : JSON.stringify({ ...arm, ...change });
    const { code } = run({ 'p.json': text }, 'p.json', '--json');
    expect(await code).toBe(1);
    expect(errors.join('\n')).toContain(message);
    expect(out).toEqual([]);
  });

  it('reports a file that is not there, and wrong usage', async () => {
    expect(await run({}, 'none.json').code).toBe(1);
    expect(errors[0]).toContain('none.json: expected a file that can be read');
    await expect(run({}).code).rejects.toThrow(UsageError);
    await expect(run({}, 'a', '--method', 'magic').code).rejects.toThrow('expected --method dls');
    await expect(run({}, 'a.json', 'b.json').code).rejects.toThrow('one file of problems');
    await expect(run({}, 'a.skel', '--pin', '#0').code).rejects.toThrow('expected --target');
    const words = ['a.skel', '--target', '#1=1,2', '--out', 'o.json'];
    await expect(run({}, ...words).code).rejects.toThrow("expected --target 'JOINT=x,y,z'");
  });
});

describe('ik of a character', () => {
  /** Where a joint is in the written pose. */
  async function placeIn(folder: string, joint: number, point = [0, 0, 0]): Promise<number[]> {
    const { skeleton } = await readOne({ 'a.skel': skel });
    const text = readFileSync(join(folder, 'o.json'), 'utf8');
    const { q } = readPoseJson('o.json', text, skeleton).value!;
    const m = jointMatrices(skeleton, q).subarray(joint * 16, joint * 16 + 16);
    return [0, 1, 2].map((row) => {
      return m[row]! * point[0]! + m[4 + row]! * point[1]! + m[8 + row]! * point[2]! + m[12 + row]!;
    });
  }

  it('writes the pose in which a joint is at its target', async () => {
    const words = ['a.skel', '--target', '#3=1,1.5,0.5', '--out', 'o.json'];
    const { folder, code } = run({ 'a.skel': skel }, ...words);
    expect(await code).toBe(0);
    expect(out[0]).toMatch(/^#3: reached, residual /);
    const place = await placeIn(folder, 3);
    expect(Math.hypot(place[0]! - 1, place[1]! - 1.5, place[2]! - 0.5)).toBeLessThan(3e-3);
  });

  it('keeps pins where they are in the starting pose, and moves the end of a bone', async () => {
    const start = '{"joints": {"#1": [0.5, 0, 0]}}';
    const { skeleton } = await readOne({ 'a.skel': skel });
    const { q } = readPoseJson('s.json', start, skeleton).value!;
    const before = [...jointMatrices(skeleton, q).subarray(2 * 16 + 12, 2 * 16 + 15)];
    const words = ['--target', '#2@tip=0.5,2.5,1', '--pin', '#2', '--pose', 's.json', '--json'];
    const { folder, code } = run(
      { 'a.skel': skel, 's.json': start },
      ...['a.skel', ...words, '--out', 'o.json'],
    );
    expect(await code).toBe(0);
    const answer = JSON.parse(out.join('')) as { pins: { name: string; status: string }[] };
    expect(answer.pins).toMatchObject([{ name: '#2', status: 'reached' }]);
    const after = await placeIn(folder, 2);
    after.forEach((value, axis) => expect(value).toBeCloseTo(before[axis]!, 3));
    const tip = await placeIn(folder, 2, [0, 1, 0]);
    const wanted = [0.5, 2.5, 1].map((value, axis) => value - before[axis]!);
    const direction = wanted.map((value) => value / Math.hypot(...wanted));
    // The tip is a length of 1 from its pinned joint, as near to the target as that allows.
    tip.forEach((value, axis) => expect(value).toBeCloseTo(before[axis]! + direction[axis]!, 1));
  });

  it('names a joint that is not there', async () => {
    const words = ['a.skel', '--target', 'Hand=1,1,0', '--out', 'o.json'];
    const { code } = run({ 'a.skel': skel }, ...words);
    await expect(code).rejects.toThrow('expected the name of a joint, or # and its index');
  });
});

function rotate(vector: number[], axis: number, angle: number): void {
  const [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
  const [a, b] = [vector[i]!, vector[j]!];
  vector[i] = Math.cos(angle) * a - Math.sin(angle) * b;
  vector[j] = Math.sin(angle) * a + Math.cos(angle) * b;
}
