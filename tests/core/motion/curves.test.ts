import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { channelFor, evaluateChannel } from '../../../src/core/motion/channel.ts';
import type { ScalarChannelParts } from '../../../src/core/motion/clip-parts.ts';
import { curveValue } from '../../reference/splines.ts';
import { scalarChannels, tangents } from '../../support/random-channels.ts';

/** The product and the oracle are both in float64; values are within thousands. */
const tolerance = 1e-9;

const at = (channel: ScalarChannelParts, time: number): number =>
  evaluateChannel(channelFor(channel), time);

/** A time within the keys, or up to three ranges of them outside. */
function timeOf({ keys }: ScalarChannelParts, fraction: number): number {
  const [start, end] = [keys[0]!.time, keys.at(-1)!.time];
  return start + (end - start + 0.1) * fraction;
}

describe.each(Object.keys(tangents))('a curve with %s tangents', (kind) => {
  it('is that of the oracle, inside its keys and outside', () => {
    fc.assert(
      fc.property(
        scalarChannels(tangents[kind]),
        fc.array(fc.double({ min: -3, max: 4, noNaN: true }), { minLength: 8, maxLength: 8 }),
        (channel, fractions) => {
          for (const fraction of fractions) {
            const time = timeOf(channel, fraction);
            if (!isClear(channel, time)) continue;
            const expected = curveValue(channel.keys, channel, time);
            expect(Math.abs(at(channel, time) - expected)).toBeLessThan(
              tolerance * (1 + Math.abs(expected)),
            );
          }
        },
      ),
      { numRuns: 60 },
    );
  });

  it('goes through its keys exactly', () => {
    fc.assert(
      fc.property(scalarChannels(tangents[kind]), (channel) => {
        const values = channel.keys.map(({ time }) => at(channel, time));
        expect(channel.keys.every(({ value }, i) => value === values[i])).toBe(true);
      }),
      { numRuns: 40 },
    );
  });
});

/**
 * Whether a time is not, up to rounding, where a key of any repetition is: there a curve may jump,
 * and what comes first decides.
 */
function isClear({ keys }: ScalarChannelParts, time: number): boolean {
  const [start, end] = [keys[0]!.time, keys.at(-1)!.time];
  const fromRepeated = (distance: number): number => {
    const periods = distance / (end - start || 1);
    return Math.abs(periods - Math.round(periods));
  };
  return keys.every(
    (key) =>
      fromRepeated(time - key.time) > 1e-6 && fromRepeated(time - start - end + key.time) > 1e-6,
  );
}

describe('an automatic curve', () => {
  it('stays between the values of neighboring keys', () => {
    fc.assert(
      fc.property(
        scalarChannels(tangents.auto, { fewest: 2 }),
        fc.double({ min: 0, max: 1, noNaN: true }),
        (channel, fraction) => {
          channel.keys.slice(1).forEach((next, span) => {
            const former = channel.keys[span]!;
            const value = at(channel, former.time + (next.time - former.time) * fraction);
            expect(value).toBeGreaterThanOrEqual(Math.min(former.value, next.value) - tolerance);
            expect(value).toBeLessThanOrEqual(Math.max(former.value, next.value) + tolerance);
          });
        },
      ),
    );
  });

  it('has no bend of its own where the keys stand on a line', () => {
    const keys = [0, 1, 3, 4].map(
      (time) => ({ time, value: 2 * time, tangentIn: 'auto', tangentOut: 'auto' }) as const,
    );
    const channel = { target: null, before: 'linear', after: 'linear', keys } as const;
    for (const time of [-1, 0.5, 2.2, 3.9, 7]) expect(at(channel, time)).toBeCloseTo(2 * time, 12);
  });
});

it('angles of curves never wrap', () => {
  const keys = [
    { time: 0, value: Math.PI, tangentIn: 'linear', tangentOut: 'linear' },
    { time: 1, value: 3 * Math.PI, tangentIn: 'linear', tangentOut: 'linear' },
  ] as const;
  const channel = { target: null, before: 'cycle_offset', after: 'linear', keys } as const;
  expect(at(channel, 0)).toBe(Math.PI);
  expect(at(channel, 1)).toBe(3 * Math.PI);
  expect(at(channel, 0.5)).toBeCloseTo(2 * Math.PI, 12);
  expect(at(channel, 3)).toBeCloseTo(7 * Math.PI, 12);
  expect(at(channel, -1)).toBeCloseTo(-Math.PI, 12);
});
