import { join } from 'node:path';
import { afterEach, expect, it, vi } from 'vitest';
import { sample } from '../../src/cli/sample.ts';
import { largestDifference } from '../support/compare.ts';
import { folderWith } from '../cli/run-sinew.ts';
import { describeWithShared, sharedJson } from './shared-material.ts';

afterEach(() => {
  vi.restoreAllMocks();
  vi.unstubAllEnvs();
});

/** What the command prints for a channel of a motion. */
async function sampled<Value>(
  motion: unknown,
  channel: string,
  times: readonly number[],
): Promise<readonly Value[]> {
  const folder = folderWith({ 'm.json': JSON.stringify(motion) });
  vi.stubEnv('INIT_CWD', folder);
  const printed: string[] = [];
  vi.spyOn(console, 'log').mockImplementation((line: string) => printed.push(line));
  const words = [join(folder, 'm.json'), '--channel', channel, '--times', times.join(), '--json'];
  expect(await sample.run(words)).toBe(0);
  return (JSON.parse(printed[0]!) as { values: readonly Value[] }).values;
}

interface Sampled {
  readonly range: readonly number[];
  readonly times: readonly number[];
  readonly channels: readonly {
    readonly extrapolate: readonly string[];
    readonly keys: readonly (readonly [number, number, string, string])[];
    readonly values: readonly number[];
  }[];
}

describeWithShared('sample.anim as MOTION.json', ['reference/splines/anim-sample.json'], () => {
  const { sample: known } = sharedJson('reference/splines/anim-sample.json') as { sample: Sampled };
  const slope = (word: string): string | number => (/^[a-z]/.test(word) ? word : Number(word));
  const motion = {
    range: known.range,
    channels: known.channels.map(({ extrapolate, keys }, index) => ({
      target: { joint: 'Right elbow', value: ['rx', 'ry', 'rz'][index] },
      extrapolate,
      keys: keys.map(([time, value, tangentIn, tangentOut]) => {
        return [time, value, slope(tangentIn), slope(tangentOut)];
      }),
    })),
  };

  it.each([0, 1, 2])(
    'has the values of the reference, inside and outside its keys: %#',
    async (i) => {
      const name = `Right elbow.r${'xyz'[i]!}`;
      const values = await sampled<number>(motion, name, known.times);
      expect(largestDifference(values, known.channels[i]!.values)).toBeLessThan(1e-5);
    },
  );
});

type Wxyz = readonly [number, number, number, number];

interface Rotations {
  readonly keys: readonly Wxyz[];
  readonly u: readonly number[];
  readonly slerp: readonly Wxyz[];
  readonly squad: readonly Wxyz[];
}

describeWithShared('rotations as MOTION.json', ['reference/splines/quaternion.json'], () => {
  const known = sharedJson('reference/splines/quaternion.json') as Rotations;

  it.each(['slerp', 'squad'] as const)(
    '%s is as in the reference, up to sign',
    async (rotation) => {
      const keys = known.keys.map(([w, x, y, z], time) => [time, [x, y, z, w]]);
      const motion = { channels: [{ target: { joint: 'Neck', rotation }, keys }] };
      const values = await sampled<readonly number[]>(motion, 'Neck.rotation', known.u);
      values.forEach((value, at) => {
        const [w, x, y, z] = known[rotation][at]!;
        const expected = [x, y, z, w];
        const sign = Math.sign(expected.reduce((sum, part, i) => sum + part * value[i]!, 0));
        expect(
          largestDifference(
            value,
            expected.map((part) => part * sign),
          ),
        ).toBeLessThan(1e-6);
      });
    },
  );
});
