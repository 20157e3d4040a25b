import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { channelFor, evaluateChannel } from '../../../src/core/motion/channel.ts';
import type {
  ClipParts,
  Quaternion,
  ScalarChannelParts,
} from '../../../src/core/motion/clip-parts.ts';
import { channelOf, removeChannels } from '../../../src/core/motion/edit/channels.ts';
import { copyKeys, pasteKeys } from '../../../src/core/motion/edit/copy-keys.ts';
import { setExtrapolation } from '../../../src/core/motion/edit/extrapolation.ts';
import { moveKeys, scaleKeys } from '../../../src/core/motion/edit/move-keys.ts';
import { removeKeys } from '../../../src/core/motion/edit/remove-keys.ts';
import {
  keysWithin,
  selectedIn,
  toggled,
  united,
} from '../../../src/core/motion/edit/selection.ts';
import { changeKey, setKey } from '../../../src/core/motion/edit/set-key.ts';
import { setTangents } from '../../../src/core/motion/edit/tangents.ts';
import type { KeySelection } from '../../../src/core/motion/key-selection.ts';
import { largestDifference } from '../../support/compare.ts';
import { anyTangent, clipOf, scalarChannels, tangents } from '../../support/random-channels.ts';

const morph = { of: 'morph', morph: 0 } as const;
const other = { of: 'morph', morph: 1 } as const;
const neck = { of: 'rotation', joint: 3, curve: 'squad' } as const;
const turned: Quaternion = [0, 0, 1, 0];

function ramp(target: ScalarChannelParts['target'], ...times: readonly number[]) {
  const keys = times.map((time) => ({ time, value: 10 * time, tangentIn: 'auto', tangentOut: 2 }));
  return { target, before: 'constant', after: 'linear', keys } as ScalarChannelParts;
}

const clip = clipOf(ramp(morph, 0, 1, 2, 3), ramp(other, 0.5, 1.5), ramp(null, 0, 9), {
  ...{ target: neck, before: 'constant', after: 'constant' },
  keys: [0, 1].map((time) => ({ time, value: turned })),
});

const select = (key: string, ...times: readonly number[]): KeySelection => new Map([[key, times]]);
const timesOf = (edited: ClipParts, key: string) =>
  channelOf(edited, key)?.keys.map(({ time }) => time);
const valuesOf = (edited: ClipParts, key: string) =>
  channelOf(edited, key)?.keys.map(({ value }) => value);

describe('a selection of keys', () => {
  it('is what exists of it, in the order of channels and times', () => {
    const selection = new Map([
      ['morph 1', [1.5]],
      ['morph 0', [2, 1.00004, 1, 7]],
      ['morph 8', [1]],
    ]);
    const found = selectedIn(clip, selection);
    expect(found.map(({ channelKey, index }) => [channelKey, index])).toEqual([
      ['morph 0', 1],
      ['morph 0', 2],
      ['morph 1', 1],
    ]);
  });

  it('by a box has the keys of its channels between two times', () => {
    const keys = ['morph 0', 'morph 1', 'rotation 3'];
    expect([...keysWithin(clip, keys, [1.5, 0.5])]).toEqual([
      ['morph 0', [1]],
      ['morph 1', [0.5, 1.5]],
      ['rotation 3', [1]],
    ]);
    expect(keysWithin(clip, [], [0, 9]).size).toBe(0);
  });

  it('is toggled and united, by the times of keys', () => {
    const [a, b] = [select('morph 0', 0, 1), select('morph 0', 1.00001, 2)];
    expect([...united(a, b)]).toEqual([['morph 0', [0, 1, 2]]]);
    expect([...toggled(a, b)]).toEqual([['morph 0', [0, 2]]]);
    expect(toggled(a, a).size).toBe(0);
  });
});

describe('moved keys', () => {
  it('replace the ones they come to, and stay selected', () => {
    const edited = moveKeys(clip, select('morph 0', 0, 1), { seconds: 1, value: 5 });
    expect(timesOf(edited.clip, 'morph 0')).toEqual([1, 2, 3]);
    expect(valuesOf(edited.clip, 'morph 0')).toEqual([5, 15, 30]);
    expect([...edited.selection]).toEqual([['morph 0', [1, 2]]]);
  });

  it('pass others, and leave the other channels the same objects', () => {
    const edited = moveKeys(clip, select('morph 0', 0), { seconds: 2.5 });
    expect(timesOf(edited.clip, 'morph 0')).toEqual([1, 2, 2.5, 3]);
    clip.channels.slice(1).forEach((each) => expect(edited.clip.channels).toContain(each));
  });

  it('keep the value of a rotation', () => {
    const edited = moveKeys(clip, select('rotation 3', 1), { seconds: 1, value: 5 });
    expect(valuesOf(edited.clip, 'rotation 3')).toEqual([turned, turned]);
    expect(timesOf(edited.clip, 'rotation 3')).toEqual([0, 2]);
  });

  it('come back', () => {
    fc.assert(
      fc.property(
        scalarChannels(anyTangent),
        fc.double({ min: -9, max: 9, noNaN: true }),
        (channel, seconds) => {
          const all = keysWithin(clipOf(channel), ['morph 0'], [-99, 99]);
          const moved = moveKeys(clipOf(channel), all, { seconds, value: 3 });
          const back = moveKeys(moved.clip, moved.selection, { seconds: -seconds, value: -3 });
          expectNear(back.clip, channel);
        },
      ),
      { numRuns: 40 },
    );
  });
});

describe('scaled keys', () => {
  it('come back, with their fixed slopes', () => {
    const factor = fc.double({ min: 0.5, max: 4, noNaN: true });
    fc.assert(
      fc.property(scalarChannels(anyTangent), factor, factor, (channel, time, value) => {
        const all = keysWithin(clipOf(channel), ['morph 0'], [-99, 99]);
        const about = { aboutTime: 1, aboutValue: 2 };
        const scaled = scaleKeys(clipOf(channel), all, {
          ...about,
          timeFactor: time,
          valueFactor: value,
        });
        const back = scaleKeys(scaled.clip, scaled.selection, {
          ...about,
          timeFactor: 1 / time,
          valueFactor: 1 / value,
        });
        expectNear(back.clip, channel);
      }),
      { numRuns: 40 },
    );
  });

  it('are at one time if there is no extent left, where the last one stays', () => {
    const all = keysWithin(clip, ['morph 0'], [0, 9]);
    const edited = scaleKeys(clip, all, { aboutTime: 1, timeFactor: 0 });
    expect(channelOf(edited.clip, 'morph 0')!.keys).toEqual([
      { time: 1, value: 30, tangentIn: 'auto', tangentOut: 2 },
    ]);
    expect([...edited.selection]).toEqual([['morph 0', [1]]]);
  });

  const smooth = Object.keys(tangents).filter((kind) => kind !== 'stepped');
  it.each(smooth)('are the motion backward by a negative factor, with %s tangents', (kind) => {
    fc.assert(
      fc.property(scalarChannels(tangents[kind], { fewest: 2 }), (channel) => {
        const all = keysWithin(clipOf(channel), ['morph 0'], [-99, 99]);
        const edited = scaleKeys(clipOf(channel), all, { aboutTime: 1, timeFactor: -1 }).clip;
        const [a, b] = [channel, edited.channels[0] as ScalarChannelParts].map(channelFor);
        const [start, end] = [channel.keys[0]!.time, channel.keys.at(-1)!.time];
        const times = Array.from(
          { length: 40 },
          (_, i) => start + ((end - start) * (i + 0.5)) / 40,
        );
        const forward = times.map((time) => evaluateChannel(a!, time));
        const backward = times.map((time) => evaluateChannel(b!, 2 - time));
        expect(largestDifference(forward, backward)).toBeLessThan(1e-8);
      }),
      { numRuns: 30 },
    );
  });
});

describe('removed keys', () => {
  it('take a channel with them that has no other', () => {
    const edited = removeKeys(
      clip,
      new Map([
        ['morph 1', [0.5, 1.5]],
        ['morph 0', [3]],
      ]),
    );
    expect(timesOf(edited, 'morph 0')).toEqual([0, 1, 2]);
    expect(channelOf(edited, 'morph 1')).toBeNull();
    expect(removeKeys(clip, select('morph 0', 0.4))).toBe(clip);
  });

  it('are all those of removed channels', () => {
    const edited = removeChannels(clip, ['morph 0', 'rotation 3']);
    expect(edited.channels).toEqual([clip.channels[1], clip.channels[2]]);
  });
});

describe('pasted keys', () => {
  const copied = copyKeys(
    clip,
    new Map([
      ['morph 0', [1, 3]],
      ['rotation 3', [0]],
    ]),
  );

  it('begin at the time, as they were to each other', () => {
    const edited = pasteKeys(clip, copied, 2);
    expect(timesOf(edited.clip, 'morph 0')).toEqual([0, 1, 2, 3, 5]);
    expect(timesOf(edited.clip, 'rotation 3')).toEqual([0, 1, 2]);
    expect(valuesOf(edited.clip, 'morph 0')).toEqual([0, 10, 20, 10, 30].with(2, 20).with(3, 10));
    expect([...edited.selection]).toEqual([
      ['morph 0', [3, 5]],
      ['rotation 3', [2]],
    ]);
  });

  it('are reversed, and their slopes change sides and signs', () => {
    const edited = pasteKeys(clipOf(), copied, 10, { reversed: true });
    expect(channelOf(edited.clip, 'morph 0')!.keys).toEqual([
      { time: 10, value: 30, tangentIn: -2, tangentOut: 'auto' },
      { time: 12, value: 10, tangentIn: -2, tangentOut: 'auto' },
    ]);
    expect(timesOf(edited.clip, 'rotation 3')).toEqual([13]);
  });

  it('of nothing change nothing', () => {
    expect(pasteKeys(clip, copyKeys(clip, new Map()), 1).clip).toBe(clip);
  });
});

describe('one key', () => {
  it('is set on its channel, which is made', () => {
    const made = setKey(clipOf(), morph, 1, 4);
    expect(made.channels).toEqual([
      {
        ...{ target: morph, before: 'constant', after: 'constant' },
        keys: [{ time: 1, value: 4, tangentIn: 'auto', tangentOut: 'auto' }],
      },
    ]);
    const rotated = setKey(setKey(made, neck, 2, turned), neck, 1, turned);
    expect(timesOf(rotated, 'rotation 3')).toEqual([1, 2]);
    expect(rotated.channels[0]).toBe(made.channels[0]);
  });

  it('keeps its tangents where it was', () => {
    const edited = setKey(clip, morph, 1.00003, 4);
    expect(channelOf(edited, 'morph 0')!.keys[1]).toEqual({
      ...{ time: 1, value: 4, tangentIn: 'auto', tangentOut: 2 },
    });
  });

  it('is changed as it is typed, and replaces another one', () => {
    const edited = changeKey(clip, 'morph 0', 1, { time: 2, value: -1, tangentOut: 'flat' });
    expect(timesOf(edited.clip, 'morph 0')).toEqual([0, 2, 3]);
    expect(channelOf(edited.clip, 'morph 0')!.keys[1]).toEqual({
      ...{ time: 2, value: -1, tangentIn: 'auto', tangentOut: 'flat' },
    });
    expect([...edited.selection]).toEqual([['morph 0', [2]]]);
    const rotated = changeKey(clip, 'rotation 3', 0, { value: [0, 1, 0, 0] });
    expect(valuesOf(rotated.clip, 'rotation 3')).toEqual([[0, 1, 0, 0], turned]);
  });
});

it('tangents are set on one side or both, of numbers only', () => {
  const all = keysWithin(clip, ['morph 1', 'rotation 3'], [0, 0.9]);
  const edited = setTangents(clip, all, 'in', 'flat');
  expect(channelOf(edited, 'morph 1')!.keys[0]).toMatchObject({ tangentIn: 'flat', tangentOut: 2 });
  expect(channelOf(edited, 'rotation 3')).toBe(channelOf(clip, 'rotation 3'));
  const both = setTangents(clip, all, 'both', { tcb: [0, 1, 0] });
  expect(channelOf(both, 'morph 1')!.keys[0]).toMatchObject({ tangentOut: { tcb: [0, 1, 0] } });
});

it('extrapolation is set at either end', () => {
  const edited = setExtrapolation(clip, 'rotation 3', 'before', 'bounce');
  expect(channelOf(edited, 'rotation 3')).toMatchObject({ before: 'bounce', after: 'constant' });
  expect(setExtrapolation(clip, 'rotation 3', 'after', 'constant')).toBe(clip);
});

function expectNear(edited: ClipParts, channel: ScalarChannelParts): void {
  const { keys } = edited.channels[0] as ScalarChannelParts;
  expect(keys.map((key) => typeof key.tangentIn)).toEqual(
    channel.keys.map((key) => typeof key.tangentIn),
  );
  const numbers = (all: ScalarChannelParts['keys']): number[] =>
    all.flatMap(({ time, value, tangentIn, tangentOut }) => [
      time,
      value,
      ...[tangentIn, tangentOut].filter((each) => typeof each === 'number'),
    ]);
  expect(largestDifference(numbers(keys), numbers(channel.keys))).toBeLessThan(1e-10);
}
