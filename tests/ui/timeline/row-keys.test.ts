import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { ChannelParts } from '../../../src/core/motion/clip-parts.ts';
import {
  firstAtOrAfter,
  keysOfRow,
  mergeTimes,
  nearestKey,
} from '../../../src/ui/timeline/row-keys.ts';
import { keyText } from '../../../src/ui/timeline/key-text.ts';
import { timelineRows } from '../../../src/ui/timeline/rows.ts';
import { channel, clipOf, key, legs, turn } from './clip.ts';

const times = fc.uniqueArray(fc.integer({ min: 0, max: 60 }), { maxLength: 12 }).map((frames) =>
  Float64Array.from(
    frames.sort((a, b) => a - b),
    (frame) => frame / 30,
  ),
);

describe('the keys of a row', () => {
  it('are at every time of its channels once, increasing', () => {
    fc.assert(
      fc.property(fc.array(times, { maxLength: 5 }), (lists) => {
        const all = [...new Set(lists.flatMap((list) => [...list]))].sort((a, b) => a - b);
        expect([...mergeTimes(lists)]).toEqual(all);
      }),
    );
  });

  it('are one where times differ less than those of two keys can', () => {
    const merged = mergeTimes([Float64Array.of(0, 1), Float64Array.of(0.00001, 1.00001, 2)]);
    expect([...merged]).toEqual([0, 1, 2]);
  });

  it('are held where no channel moves, and some channel has keys on both sides', () => {
    const held = channel(turn(0, 0), [0, 1, 2], [5, 5, 7]);
    const later = channel(turn(0, 1), [1.5, 2, 3], [1, 1, 1]);
    expect([...keysOfRow([held]).isHeld]).toEqual([1, 0, 0]);
    const both = keysOfRow([held, later]);
    expect([...both.times]).toEqual([0, 1, 1.5, 2, 3]);
    expect([...both.isHeld]).toEqual([1, 0, 0, 1, 0]);
  });

  it('do not hold where equal values have a curve between them', () => {
    const [from, to] = [key(0, 5), key(1, 5)];
    const bent = { ...channel(turn(0, 0), []), keys: [{ ...from, tangentOut: 3 }, to] };
    expect([...keysOfRow([bent as ChannelParts]).isHeld]).toEqual([0, 0]);
  });

  it('are found as a search through all of them finds them', () => {
    const time = fc.double({ min: -0.5, max: 2.5, noNaN: true });
    fc.assert(
      fc.property(times, time, fc.double({ min: 0, max: 0.2, noNaN: true }), (list, at, reach) => {
        const first = [...list].findIndex((each) => each >= at);
        expect(firstAtOrAfter(list, at)).toBe(first < 0 ? list.length : first);
        const found = nearestKey(list, at, reach);
        const least = Math.min(...[...list].map((each) => Math.abs(each - at)));
        if (least > reach) expect(found).toBe(-1);
        else expect(Math.abs(list[found]! - at)).toBe(least);
      }),
    );
  });

  it('are read with their place among the others, their time and their value', async () => {
    const clip = clipOf([
      channel(turn(2, 0), [0, 0.5, 1], [0, Math.PI / 6, 1]),
      channel(turn(2, 1), [0.5]),
    ]);
    const rows = timelineRows(clip, await legs(), {
      ...{ turned: new Set(), allJoints: false },
      selected: [2],
    });
    const [, joint, x] = rows;
    expect(keyText(x!, 1, 30, 'seconds')).toBe('shin X, key 2 of 3, 0.50 s, 30°');
    expect(keyText(joint!, 1, 30, 'frames')).toBe('shin, key 2 of 3, frame 15, 2 values');
  });
});
