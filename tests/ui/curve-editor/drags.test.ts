import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { channelFor } from '../../../src/core/motion/channel.ts';
import type { ClipParts, ScalarChannelParts } from '../../../src/core/motion/clip-parts.ts';
import { type KeySelection } from '../../../src/core/motion/key-selection.ts';
import { fixSlopes, oneKey, unifySlopes } from '../../../src/ui/curve-editor/curve-edits.ts';
import { handlesOf, isUnified, slopeToward } from '../../../src/ui/curve-editor/handles.ts';
import {
  type DragStart,
  movingKeys,
  scalingKeys,
  turningHandle,
} from '../../../src/ui/curve-editor/key-drags.ts';
import { boxAround, handlePlace } from '../../../src/ui/curve-editor/scale-box.ts';
import { clipOf, hinge, key, lineOf, plot } from './lines.ts';

const none = { shift: false, alt: false };
const channel = hinge(0, [key(1, 0), key(2, 0.5), key(3, 0)]);
const clip = clipOf(channel);
const line = lineOf(channel);

function start(selection: KeySelection, more: Partial<DragStart> = {}): DragStart {
  const scales = new Map([[line.key, line.scale]]);
  return { from: { x: 200, y: 50 }, plot, selection, scales, fps: 30, snaps: false, ...more };
}

const keysOf = ({ channels }: ClipParts) =>
  (channels[0] as ScalarChannelParts).keys.map(({ time, value }) => [time, value]);
const slopesOf = ({ channels }: ClipParts, at: number) => {
  const { slopesIn, slopesOut } = channelFor(channels[0] as ScalarChannelParts);
  return [slopesIn[at], slopesOut[at]];
};

describe('a drag of keys', () => {
  const drag = movingKeys(start(oneKey(line.key, 2)), { line, at: 1 }, 'angle');

  it('moves them by what the pointer moves in time and value, and says so', () => {
    const { edit, telling, label } = drag({ x: 230, y: 30 }, none);
    const { clip: edited, selection } = edit(clip);
    expect(keysOf(edited)[1]![0]).toBeCloseTo(2.3, 9);
    expect(keysOf(edited)[1]![1]).toBeCloseTo(0.7, 9);
    expect(selection.get(line.key)![0]).toBeCloseTo(2.3, 9);
    expect([label, telling]).toEqual(['Move 1 key', 'Move 1 key: +0.30 s (+9 frames), +11.5°']);
  });

  it('keeps to one direction with Shift', () => {
    const across = drag({ x: 230, y: 45 }, { ...none, shift: true }).edit(clip).clip;
    expect(keysOf(across)[1]![1]).toBe(0.5);
    const down = drag({ x: 205, y: 20 }, { ...none, shift: true }).edit(clip).clip;
    expect(keysOf(down)[1]![0]).toBe(2);
    expect(keysOf(down)[1]![1]).toBeCloseTo(0.8, 9);
  });

  it('puts the pressed key on a frame where times are those of frames', () => {
    const snapping = movingKeys(
      start(oneKey(line.key, 2), { snaps: true }),
      { line, at: 1 },
      'angle',
    );
    fc.assert(
      fc.property(fc.integer({ min: -80, max: 80 }), (x) => {
        const { selection } = snapping({ x: 200 + x, y: 50 }, none).edit(clip);
        const frame = selection.get(line.key)![0]! * 30;
        expect(frame).toBeCloseTo(Math.round(frame), 6);
      }),
    );
  });

  it('moves a fitted curve by its own values', () => {
    const fitted = lineOf(channel, true);
    const scales = new Map([[line.key, fitted.scale]]);
    const pressed = { line: fitted, at: 1 };
    const moving = movingKeys(start(oneKey(line.key, 2), { scales }), pressed, 'angle');
    // Half of the plot's height is half of the curve's range.
    const { clip: edited } = moving({ x: 200, y: 100 }, none).edit(clip);
    expect(keysOf(edited)[1]![1]).toBeCloseTo(0.375, 9);
  });
});

describe('a drag of a handle', () => {
  it('gives the slope toward the pointer, on both sides if they were one', () => {
    const handle = handlesOf(line, 1, plot)[1]!;
    const drag = turningHandle(start(oneKey(line.key, 2)), handle, false, 'angle');
    const { edit, telling } = drag({ x: 230, y: 35 }, none);
    expect(slopesOf(edit(clip).clip, 1)).toEqual([0.5, 0.5]);
    expect(telling).toBe('Slope 28.6°/s, both sides');
    const turned = drag({ x: 230, y: 35 }, { ...none, alt: true }).edit(clip).clip;
    expect(slopesOf(turned, 1)).toEqual([0, 0.5]);
  });

  it('turns one side of a broken key, and unifying gives both the mean', () => {
    const broken = hinge(0, [
      key(1, 0),
      { time: 2, value: 0.5, tangentIn: 1, tangentOut: -3 },
      key(3, 0),
    ]);
    const bent = lineOf(broken);
    expect([isUnified(line, 1), isUnified(bent, 1)]).toEqual([true, false]);
    const handle = handlesOf(bent, 1, plot)[0]!;
    const drag = turningHandle(start(oneKey(line.key, 2)), handle, false, 'angle');
    const { clip: edited } = drag({ x: 170, y: 80 }, none).edit(clipOf(broken));
    expect(slopesOf(edited, 1)).toEqual([1, -3]);
    const unified = unifySlopes(clipOf(broken), oneKey(line.key, 2));
    expect(slopesOf(unified, 1)).toEqual([-1, -1]);
  });

  it('never crosses its key, and undoes what the handle shows', () => {
    fc.assert(
      fc.property(
        fc.double({ min: -3, max: 3, noNaN: true }),
        fc.boolean(),
        (slope, isNormalized) => {
          const sloped = hinge(0, [key(1, 0), key(2, 0.5, slope), key(3, 0)]);
          for (const handle of handlesOf(lineOf(sloped, isNormalized), 1, plot)) {
            expect(slopeToward(handle, handle.end, plot)).toBeCloseTo(slope, 9);
            const across = { x: 2 * handle.key.x - handle.end.x, y: handle.key.y - 5 };
            expect(Number.isFinite(slopeToward(handle, across, plot))).toBe(true);
          }
        },
      ),
    );
  });

  it('is not there where a slope has no effect', () => {
    const stepped = lineOf(hinge(0, [key(1, 0, 'stepped'), key(2, 1), key(3, 0)]));
    expect(handlesOf(stepped, 0, plot)).toEqual([]);
    expect(handlesOf(stepped, 1, plot).map(({ side }) => side)).toEqual(['out']);
    const going = lineOf(hinge(0, [key(1, 0), key(2, 1)], 'linear'));
    expect(handlesOf(going, 0, plot).map(({ side }) => side)).toEqual(['in', 'out']);
  });

  it('fixes slopes as numbers without changing the curve', () => {
    const fixed = fixSlopes(clip, oneKey(line.key, 1), 'both');
    expect((fixed.channels[0] as ScalarChannelParts).keys[0]!.tangentOut).toBe(0.5);
    expect(slopesOf(fixed, 0)).toEqual(slopesOf(clip, 0));
  });
});

describe('the box around keys', () => {
  const keys = new Map([[line.key, [1, 2]]]);
  // The keys at (100, 100) and (200, 50).
  const box = boxAround([
    { x: 100, y: 100 },
    { x: 200, y: 50 },
  ])!;

  it('scales about its opposite side, by a corner in both directions', () => {
    const handle = { across: 1, down: -1 } as const;
    const from = handlePlace(box, handle);
    const drag = scalingKeys(start(keys, { from }), box, handle);
    const to = { x: from.x + 50, y: from.y + 25 };
    const { edit, telling } = drag(to, none);
    const scaled = keysOf(edit(clip).clip);
    expect(scaled[0]).toEqual([1, 0]);
    expect(scaled[1]![0]).toBeCloseTo(2.5, 9);
    expect(scaled[1]![1]).toBeCloseTo(0.25, 9);
    expect(telling).toBe('Scale 2 keys: 150 % of the time, 50 % of the value');
  });

  it('scales in one direction by a side, and past the other side reverses', () => {
    const handle = { across: -1, down: 0 } as const;
    const from = handlePlace(box, handle);
    const drag = scalingKeys(start(keys, { from, snaps: true }), box, handle);
    const { clip: edited } = drag({ x: from.x + 151, y: 10 }, none).edit(clip);
    expect(keysOf(edited).map(([time]) => time)).toEqual([2, 2.5, 3]);
    expect(keysOf(edited)[0]![1]).toBe(0.5);
  });
});
