import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { channelFor, evaluateChannel } from '../../../src/core/motion/channel.ts';
import type {
  RotationChannelParts,
  ScalarChannelParts,
} from '../../../src/core/motion/clip-parts.ts';
import { channelOf } from '../../../src/core/motion/edit/channels.ts';
import { insertKey } from '../../../src/core/motion/edit/insert-key.ts';
import { removeKeys } from '../../../src/core/motion/edit/remove-keys.ts';
import { squadTurnOnInsert } from '../../../src/core/motion/edit/squad-turn.ts';
import { turnAngle } from '../../../src/core/motion/quaternions.ts';
import { evaluateRotation, rotationChannelFor } from '../../../src/core/motion/rotation-channel.ts';
import { channelKey } from '../../../src/core/motion/targets.ts';
import { squadRotation, turnBetween, type Wxyz } from '../../reference/splines.ts';
import {
  anyTangent,
  clipOf,
  rotationChannels,
  scalarChannels,
  tangents,
} from '../../support/random-channels.ts';

/** What a new key may change of a curve of numbers: the tolerance. */
const tolerance = 1e-9;

function inserted(channel: ScalarChannelParts, time: number) {
  const key = channelKey(channel.target!);
  const clip = clipOf(channel);
  const edited = insertKey(clip, key, time);
  return { before: clip, key, ...edited, after: channelOf(edited.clip, key) as ScalarChannelParts };
}

function expectSameCurve(before: ScalarChannelParts, after: ScalarChannelParts): void {
  const [a, b] = [channelFor(before), channelFor(after)];
  const [start, end] = [before.keys[0]!.time, before.keys.at(-1)!.time];
  const reach = end - start + 1;
  for (let i = 0; i <= 150; i++) {
    const time = start - reach + (i / 150) * 3 * reach;
    const [from, to] = [evaluateChannel(a, time), evaluateChannel(b, time)];
    // Curves that go on with a steep slope come to thousands outside.
    const size = time < start || time > end ? Math.max(1, Math.abs(from)) : 1;
    expect(Math.abs(from - to), `at ${time}`).toBeLessThan(tolerance * size);
  }
}

describe.each([...Object.keys(tangents), 'mixed'])('a key on a curve with %s tangents', (kind) => {
  const channels = scalarChannels(tangents[kind] ?? anyTangent, { fewest: 2 });
  it('changes nothing between its keys and outside, whatever the extrapolation', () => {
    fc.assert(
      fc.property(channels, fc.double({ min: 0.01, max: 0.99, noNaN: true }), (channel, part) => {
        const [start, end] = [channel.keys[0]!.time, channel.keys.at(-1)!.time];
        const { after } = inserted(channel, start + (end - start) * part);
        if (after === channel) return;
        expect(after.keys.length).toBe(channel.keys.length + 1);
        expectSameCurve(channel, after);
      }),
      { numRuns: 60 },
    );
  });

  it('may be outside the keys where the curve does not repeat', () => {
    const rules = fc.constantFrom('constant' as const, 'linear' as const);
    fc.assert(
      fc.property(
        fc.record({ channel: channels, before: rules, after: rules }),
        fc.constantFrom(-0.7, 0.7),
        ({ channel, before, after }, distance) => {
          const plain = { ...channel, before, after };
          const end = distance < 0 ? plain.keys[0]! : plain.keys.at(-1)!;
          expectSameCurve(plain, inserted(plain, end.time + distance).after);
        },
      ),
      { numRuns: 60 },
    );
  });
});

describe('a key on a curve', () => {
  const smooth = (time: number, value: number) =>
    ({ time, value, tangentIn: 'smooth', tangentOut: 'smooth' }) as const;
  const channel: ScalarChannelParts = {
    target: { of: 'morph', morph: 0 },
    before: 'constant',
    after: 'cycle',
    keys: [smooth(0, 0), smooth(1, 2), smooth(2, 1), smooth(3, 5)],
  };

  it('makes numbers of the slopes of its neighbors and of itself, and of no other', () => {
    const { after, fixed } = inserted(channel, 1.5);
    expect(fixed).toEqual([1, 1.5, 2]);
    expect(after.keys.map(({ tangentIn }) => typeof tangentIn)).toEqual([
      'string',
      'number',
      'number',
      'number',
      'string',
    ]);
    expect(after.keys[1]).toMatchObject({ tangentIn: 0.5, tangentOut: 0.5 });
  });

  it('is on the only value of a curve of one key', () => {
    const one = { ...channel, keys: [{ ...smooth(1, 7), tangentOut: 4 }] };
    const { after } = inserted(one, 3);
    expectSameCurve(one, after);
    expect(after.keys).toHaveLength(2);
  });

  it('is not made where one is, nor outside of keys that repeat', () => {
    for (const time of [1, 1.00005, 3.5, -1]) {
      const { clip, after, fixed } = inserted(channel, time);
      expect([after === channel, fixed.length, clip.channels[0] === channel]).toEqual([
        true,
        0,
        true,
      ]);
    }
  });

  it('can be removed; the slopes of its neighbors stay numbers', () => {
    const { clip, key, after } = inserted(channel, 1.5);
    const removed = removeKeys(clip, new Map([[key, [1.5]]])).channels[0] as ScalarChannelParts;
    expect(removed.keys).toEqual(after.keys.filter(({ time }) => time !== 1.5));
  });
});

describe('a key on a curve of rotations', () => {
  const wxyz = ({ keys }: RotationChannelParts) =>
    keys.map(({ time, value: [x, y, z, w] }) => ({ time, value: [w, x, y, z] as Wxyz }));

  it('does not change a slerp', () => {
    fc.assert(
      fc.property(
        rotationChannels('slerp'),
        fc.double({ min: 0.05, max: 0.95 }),
        (channel, part) => {
          const [start, end] = [channel.keys[0]!.time, channel.keys.at(-1)!.time];
          const edited = insertKey(
            clipOf(channel),
            'rotation 0',
            start + (end - start) * part,
          ).clip;
          const after = rotationChannelFor(edited.channels[0] as RotationChannelParts);
          const before = rotationChannelFor(channel);
          const [a, b] = [new Float64Array(4), new Float64Array(4)];
          for (let i = 0; i <= 50; i++) {
            const time = start + ((end - start) * i) / 50;
            evaluateRotation(before, time, a);
            evaluateRotation(after, time, b);
            expect(turnAngle(a, b)).toBeLessThan(1e-7);
          }
        },
      ),
      { numRuns: 30 },
    );
  });

  it('turns a squad by what was said, to 0.01°', () => {
    const hundredth = (0.01 * Math.PI) / 180;
    fc.assert(
      fc.property(
        rotationChannels('squad', { fewest: 3 }),
        fc.double({ min: 0.05, max: 0.95, noNaN: true }),
        (channel, part) => {
          const [start, end] = [channel.keys[0]!.time, channel.keys.at(-1)!.time];
          const time = start + (end - start) * part;
          const edited = insertKey(clipOf(channel), 'rotation 0', time).clip;
          const after = edited.channels[0] as RotationChannelParts;
          fc.pre(after !== channel);
          const [before, changed] = [wxyz(channel), wxyz(after)];
          let largest = 0;
          for (let span = 1; span < changed.length; span++) {
            const [from, to] = [changed[span - 1]!.time, changed[span]!.time];
            for (let i = 0; i <= 600; i++) {
              const moment = from + ((to - from) * i) / 600;
              const turn = turnBetween(
                squadRotation(before, moment),
                squadRotation(changed, moment),
              );
              largest = Math.max(largest, turn);
            }
          }
          expect(Math.abs(squadTurnOnInsert(channel, time) - largest)).toBeLessThan(hundredth);
        },
      ),
      { numRuns: 12 },
    );
  });
});
