import { describe, expect, it } from 'vitest';
import { channelFor, evaluateChannel } from '../../../src/core/motion/channel.ts';
import type {
  ScalarChannelParts,
  Extrapolation,
  Tangent,
} from '../../../src/core/motion/clip-parts.ts';
import { clipFor, evaluateClip } from '../../../src/core/motion/clip.ts';
import { axisDofs } from '../../../src/core/pose.ts';
import { leg } from '../../support/cse169-files.ts';
import { clipValues } from '../../support/clip-values.ts';
import { readOne } from '../../support/files.ts';

type Key = readonly [number, number, Tangent, Tangent];

function channel(before: Extrapolation, after: Extrapolation, keys: readonly Key[]) {
  const parts: ScalarChannelParts = {
    target: null,
    before,
    after,
    keys: keys.map(([time, value, tangentIn, tangentOut]) => ({
      time,
      value,
      tangentIn,
      tangentOut,
    })),
  };
  const compiled = channelFor(parts);
  return { ...compiled, at: (time: number) => evaluateChannel(compiled, time) };
}

const ramp: readonly Key[] = [
  [1, 2, 'linear', 'linear'],
  [3, 6, 'linear', 'linear'],
];

describe('a channel', () => {
  it('is 0 without keys and constant with one, whatever the rule', () => {
    expect(channel('cycle', 'linear', []).at(5)).toBe(0);
    const one = channel('bounce', 'cycle_offset', [[1, 7, 5, 5]]);
    expect([one.at(-3), one.at(1), one.at(9)]).toEqual([7, 7, 7]);
  });

  it('has the slopes of its tangents, linear at the ends of smooth ones', () => {
    const keys: readonly Key[] = [
      [0, 0, 'smooth', 'smooth'],
      [1, 2, 'smooth', 'linear'],
      [3, 4, 'linear', 'flat'],
      [4, 0, 13.7, 'smooth'],
    ];
    const { slopesIn, slopesOut } = channel('constant', 'constant', keys);
    expect([...slopesIn]).toEqual([2, 4 / 3, 1, 13.7]);
    expect([...slopesOut]).toEqual([2, 1, 0, -4]);
  });

  it('reads the slope out of a key from the second tangent, not the first', () => {
    const { at } = channel('linear', 'linear', [
      [0, 0, 5, -2],
      [1, 0, 3, 7],
    ]);
    expect(at(-1)).toBe(-5);
    expect(at(2)).toBe(7);
    expect(at(0.5)).toBeCloseTo(0.125 * -2 - 0.125 * 3, 12);
  });

  it.each<[Extrapolation, number[]]>([
    ['constant', [2, 2, 6, 6]],
    ['linear', [-3, 0, 7, 13]],
    // The period is 2 and starts at time 1: -1.5 corresponds to 1.5, 0 to 1, 3.5 to 0.5 and 6.5 to
    // 1.5.
    ['cycle', [5, 4, 3, 5]],
    ['cycle_offset', [-3, 0, 7, 13]],
    ['bounce', [5, 4, 5, 5]],
  ])('goes on by the rule %s', (rule, expected) => {
    const { at } = channel(rule, rule, ramp);
    [-1.5, 0, 3.5, 6.5].forEach((time, i) => expect(at(time)).toBeCloseTo(expected[i]!, 12));
  });

  it('is its last value at the last key, and the first again after a period', () => {
    const { at } = channel('cycle', 'cycle', ramp);
    expect([at(3), at(5), at(-1), at(1)]).toEqual([6, 2, 2, 2]);
    expect(at(3 + 1e-9)).toBeCloseTo(2, 6);
  });

  it('stays finite far from its keys', () => {
    for (const rule of ['cycle', 'cycle_offset', 'bounce', 'linear'] as const) {
      expect(Number.isFinite(channel(rule, rule, ramp).at(1e9))).toBe(true);
      expect(Number.isFinite(channel(rule, rule, ramp).at(-1e9 / 7))).toBe(true);
    }
  });
});

describe('a clip', () => {
  it('writes its values to their places in q, within the limits, and no others', async () => {
    const character = await readOne(leg);
    const { skeleton, clips } = character;
    const clip = clipFor(clips[0]!, character);
    expect(clipFor(clips[0]!, character), 'compiled once').toBe(clip);
    const valueOf = (joint: number, kind: number, axis: number): number =>
      axisDofs(skeleton, joint).find((dof) => dof.kind === kind && dof.axis === axis)!.index;
    const slides = [0, 1, 2].map((axis) => valueOf(0, 0, axis));
    const hinges = [0, 1, 2].flatMap((joint) => [0, 1, 2].map((axis) => valueOf(joint, 1, axis)));
    expect(clip.curves.q.map(({ index }) => index)).toEqual([...slides, ...hinges]);
    const values = clipValues(character);
    const { q } = values;
    evaluateClip(clip, 0, values);
    expect([0, 1, 2].map((axis) => q[slides[axis]!])).toEqual([0.5, 0.5, 0]);
    // The hip is locked about y, while its channel has 0.25.
    expect(hinges.map((index) => q[index])).toEqual([0, 0, ...Array<number>(7).fill(0.25)]);
    expect([clip.start, clip.end, clip.name]).toEqual([0, 2, 'leg_walk']);
  });
});
