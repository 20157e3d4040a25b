import { describe, expect, it } from 'vitest';
import { channelFor, evaluateChannel } from '../../../src/core/motion/channel.ts';
import type {
  ChannelParts,
  ClipParts,
  KeyParts,
  Quaternion,
  ScalarChannelParts,
  Tangent,
} from '../../../src/core/motion/clip-parts.ts';
import { DofKind } from '../../../src/core/skeleton.ts';
import { readAnim } from '../../../src/formats/cse169/anim.ts';
import { writeAnimOf } from '../../../src/formats/cse169/anim-of-clip.ts';
import { legSkel } from '../../support/cse169-files.ts';
import { readOne } from '../../support/files.ts';
import { mover } from '../motion/mover.ts';

const { skeleton } = await readOne({ 'a.skel': legSkel });

const rules = { before: 'constant', after: 'cycle' } as const;
const kneeX = { of: 'value', joint: 1, kind: DofKind.hinge, axis: 0 } as const;

function clipOf(channels: readonly ChannelParts[], fps = 30): ClipParts {
  return { file: 'a.json', name: 'bend', start: 0, end: 2, fps, channels };
}

function curve(...keys: readonly (readonly [number, number, Tangent, Tangent])[]): ChannelParts {
  const parts = keys.map(([time, value, tangentIn, tangentOut]): KeyParts => ({
    time,
    value,
    tangentIn,
    tangentOut,
  }));
  return { target: kneeX, ...rules, keys: parts };
}

function written(clip: ClipParts) {
  const { files, losses } = writeAnimOf(clip, skeleton, skeleton.qRest);
  const { value, diagnostics } = readAnim('bend.anim', files[0]!.bytes);
  expect(diagnostics).toEqual([]);
  return {
    channels: value!.channels,
    losses: losses.map(({ found, effect }) => `${found}: ${effect}`),
  };
}

function largestChange(a: ChannelParts, b: ScalarChannelParts, times: readonly number[]): number {
  const [from, to] = [channelFor(a as ScalarChannelParts), channelFor(b)];
  return Math.max(
    ...times.map((time) => Math.abs(evaluateChannel(from, time) - evaluateChannel(to, time))),
  );
}

const times = Array.from({ length: 61 }, (_, i) => i / 20 - 0.5);

describe('a clip as .anim', () => {
  it('has the channels in the order of the file, and constants where the clip moves nothing', () => {
    const { channels, losses } = written(
      clipOf([curve([0, 0.5, 'flat', 2], [1, 1, 'linear', 'smooth'])]),
    );
    expect(channels).toHaveLength(3 + 3 * skeleton.jointCount);
    expect(channels[6]!.keys).toEqual([
      { time: 0, value: 0.5, tangentIn: 'flat', tangentOut: 2 },
      { time: 1, value: 1, tangentIn: 'linear', tangentOut: 'smooth' },
    ]);
    expect([channels[6]!.before, channels[6]!.after]).toEqual(['constant', 'cycle']);
    // The leg's own pose: 0.5 about x at the hip, -0.25 about y and 0.75 about z at the knee.
    expect([3, 7, 8].map((at) => channels[at]!.keys[0]!.value)).toEqual([0.5, -0.25, 0.75]);
    expect(losses).toEqual([]);
  });

  it('writes the slopes of other tangents, which changes no value', () => {
    const tcb = { tcb: [0.25, 0.5, -0.5] } as const;
    const own = curve([0, 0, 'auto', 'auto'], [0.7, 1, tcb, tcb], [1.5, 0.2, 'smooth', 'auto']);
    const { channels, losses } = written(clipOf([own]));
    expect(largestChange(own, channels[6]!, times)).toBe(0);
    expect(losses).toEqual(['5 others: they are fixed slopes; the largest change of value is 0']);
  });

  it('makes steps steep for a thousandth of a second, and keeps what is beside them', () => {
    const own = curve(
      [0, 0, 'auto', 'smooth'],
      [0.5, 1, 'smooth', 'stepped'],
      [1, 0.25, 'smooth', 'smooth'],
      [1.5, 2, 'stepped', 'auto'],
    );
    const { channels, losses } = written(clipOf([own]));
    const beside = times.filter((time) => Math.abs(time - 1) > 0.01);
    expect(largestChange(own, channels[6]!, beside)).toBeLessThan(1e-12);
    const at1 = channelFor(channels[6]!);
    expect([0.998, 1].map((time) => evaluateChannel(at1, time))).toEqual([1, 0.25]);
    expect(losses).toContain('2 stepped spans: each jump takes 1 ms; the largest is 1.8');
  });

  it('keeps the slopes by which curves go on from steps at their ends', () => {
    const steps = curve(
      [0, 0, 'linear', 'stepped'],
      [1, 2, 'flat', 'flat'],
      [2, 5, 'stepped', 'linear'],
    );
    const own = { ...steps, before: 'linear', after: 'linear' } as const;
    const { channels } = written(clipOf([own]));
    expect(largestChange(own, channels[6]!, [-3, -0.5, 0, 0.5, 1.5, 2, 2.5, 7])).toBeLessThan(
      1e-12,
    );
  });

  it('samples rotations at frames, and says how far they are off', () => {
    const half: Quaternion = [0, 0, Math.SQRT1_2, Math.SQRT1_2];
    const side: Quaternion = [Math.SQRT1_2, 0, 0, Math.SQRT1_2];
    const rotation: ChannelParts = {
      target: { of: 'rotation', joint: 1, curve: 'slerp' },
      ...rules,
      keys: [
        { time: 0, value: [0, 0, 0, 1] },
        { time: 1, value: half },
        { time: 2, value: side },
      ],
    };
    const { channels, losses } = written(clipOf([rotation], 24));
    expect(channels[8]!.keys).toHaveLength(49);
    const z = channelFor(channels[8]!);
    expect(evaluateChannel(z, 1)).toBeCloseTo(Math.PI / 2, 12);
    expect(losses[0]).toMatch(
      /^1 rotations: sampled at 24 frames a second; off by at most 0\.\d+°/,
    );
    expect(losses[1]).toBe('24 a second: it is 30 when it is read');
  });

  it('says which channels are left out', () => {
    const keys = [{ time: 0, value: 1, tangentIn: 'auto', tangentOut: 'auto' }] as const;
    const clip: ClipParts = {
      ...clipOf([
        { target: { of: 'morph', morph: 0 }, ...rules, keys },
        { target: { of: 'pin', joint: 1, value: 'x' }, ...rules, keys },
      ]),
      unread: [{}],
    };
    expect(written(clip).losses).toEqual([
      '1 of morphs: they are left out',
      '1 of pins: they are left out',
      "1 that Sinew can't use: they are left out",
    ]);
  });

  it('is refused for a skeleton with other joints', () => {
    const { files, losses } = writeAnimOf(clipOf([]), mover.skeleton, mover.skeleton.qRest);
    expect(files).toEqual([]);
    expect(losses).toMatchObject([{ severity: 'error', found: 'wrist and 1 more that do not' }]);
  });
});
