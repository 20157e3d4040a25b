import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { advance, type PlayMode } from '../../src/posing/playhead.ts';

const clip = { start: 1, end: 3 };

function run(mode: PlayMode, time: number, seconds: number, forward = true) {
  const { time: at, forward: onward, ended } = advance(clip, { time, forward }, seconds, mode);
  return [Number(at.toFixed(9)), onward, ended];
}

describe('the playhead', () => {
  it('stops at the end of a clip that is played once', () => {
    expect(run('once', 1, 0.5)).toEqual([1.5, true, false]);
    expect(run('once', 2.5, 1)).toEqual([3, true, true]);
  });

  it('begins again in a loop, however long a step is', () => {
    expect(run('loop', 2.5, 1)).toEqual([1.5, true, false]);
    expect(run('loop', 1, 7)).toEqual([2, true, false]);
  });

  it('turns back at both ends of a ping-pong', () => {
    expect(run('ping-pong', 2.5, 1)).toEqual([2.5, false, false]);
    expect(run('ping-pong', 2.5, 1, false)).toEqual([1.5, false, false]);
    expect(run('ping-pong', 1.5, 1, false)).toEqual([1.5, true, false]);
  });

  it('goes on past the range, for the curves to extrapolate', () => {
    expect(run('go on', 2.5, 4)).toEqual([6.5, true, false]);
  });

  it('comes into the range from a time outside of it', () => {
    expect(run('loop', 9, 0.25)).toEqual([1.25, true, false]);
    expect(run('once', 0, 0.5)).toEqual([1, true, false]);
  });

  it('stays at the only time of a range without length', () => {
    for (const mode of ['once', 'loop', 'ping-pong'] as const) {
      const found = advance({ start: 2, end: 2 }, { time: 2, forward: true }, 1, mode);
      expect(found.time).toBe(2);
    }
  });

  it('is at the same time after many small steps', () => {
    const modes = fc.constantFrom<PlayMode>('once', 'loop', 'ping-pong', 'go on');
    fc.assert(
      fc.property(modes, fc.double({ min: 0, max: 9, noNaN: true }), (mode, seconds) => {
        const whole = advance(clip, { time: 1, forward: true }, seconds, mode);
        let parts = { time: 1, forward: true };
        for (let i = 0; i < 64; i++) parts = advance(clip, parts, seconds / 64, mode);
        // Exactly at a reversal or restart, rounding may give either side.
        const gap = Math.abs(whole.time - parts.time);
        expect(Math.min(gap, Math.abs(gap - 2))).toBeLessThan(1e-9);
      }),
    );
  });
});
