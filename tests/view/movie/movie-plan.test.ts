import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  checkPlan,
  frameTime,
  frameTurn,
  movieSeconds,
  type MovieSituation,
  planMovie,
} from '../../../src/view/movie/movie-plan.ts';
import { plainMovie } from '../../../src/view/movie/movie-settings.ts';

const situation: MovieSituation = {
  clip: { start: 0.5, end: 2.5 },
  workRange: [1, 1.5],
  now: 0.75,
  view: { width: 801, height: 533 },
  ratio: null,
};

describe('the frames of a movie', () => {
  it('are as many as fit best into its time, and each is at its own time', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0, max: 100, noNaN: true }),
        fc.double({ min: 0.01, max: 100, noNaN: true }),
        fc.integer({ min: 1, max: 240 }),
        (from, seconds, rate) => {
          const to = from + seconds;
          const plan = planMovie({ ...plainMovie, range: 'typed', from, to, rate }, situation);
          expect(plan.count).toBe(Math.max(1, Math.round((to - from) * rate)));
          const last = plan.count - 1;
          expect(frameTime(plan, 0)).toBe(from);
          expect(frameTime(plan, last)).toBe(from + last / rate);
          // The last frame is shown until about the end, within half a frame.
          expect(Math.abs(from + movieSeconds(plan) - to)).toBeLessThanOrEqual(
            Math.max(0.5, 1 - seconds * rate) / rate + 1e-9,
          );
        },
      ),
    );
  });

  it('are those of the clip, of the work range, or of typed times', () => {
    const countOf = (range: 'clip' | 'work' | 'typed') => {
      const { start, count } = planMovie({ ...plainMovie, range, from: 0, to: 1 }, situation);
      return { start, count };
    };
    expect(countOf('clip')).toEqual({ start: 0.5, count: 60 });
    expect(countOf('work')).toEqual({ start: 1, count: 15 });
    expect(countOf('typed')).toEqual({ start: 0, count: 30 });
    const backwards = planMovie({ ...plainMovie, range: 'typed', from: 2, to: 1 }, situation);
    expect(backwards).toMatchObject({ start: 1, count: 30 });
    const empty = planMovie({ ...plainMovie, range: 'typed', from: 2, to: 2 }, situation);
    expect(empty).toMatchObject({ start: 2, count: 1 });
  });

  it('stay at the moment that is shown if nothing plays', () => {
    const still = planMovie({ ...plainMovie, plays: false }, situation);
    expect([0, 7, 59].map((frame) => frameTime(still, frame))).toEqual([0.75, 0.75, 0.75]);
    const without = planMovie(plainMovie, { ...situation, clip: null, workRange: null });
    expect(without).toMatchObject({ plays: false, count: 60, start: 0.75 });
  });

  it('of a turntable turn once, and the one after the last would be the first', () => {
    const settings = { ...plainMovie, turns: true, turnSeconds: 1.5, rate: 24 };
    const plan = planMovie(settings, situation);
    expect(plan.count).toBe(36);
    const angles = Array.from({ length: plan.count }, (_, frame) => frameTurn(plan, frame));
    expect(angles[0]).toBe(0);
    expect(frameTurn(plan, plan.count)).toBe(2 * Math.PI);
    const steps = angles.map((angle, frame) => frameTurn(plan, frame + 1) - angle);
    for (const step of steps) expect(step).toBeCloseTo((2 * Math.PI) / 36, 12);
    expect(frameTurn({ ...plan, turns: false }, 9)).toBe(0);
  });

  it('have even sides in video, and those that were asked for otherwise', () => {
    const sizeOf = (format: 'webm' | 'gif', size: 'view' | 'square' = 'view', ratio?: number) =>
      planOf(format, size, ratio).size;
    const planOf = (format: 'webm' | 'gif', size: 'view' | 'square', ratio?: number) =>
      planMovie({ ...plainMovie, format, size }, { ...situation, ratio: ratio ?? null });
    expect(sizeOf('webm')).toEqual({ width: 800, height: 532 });
    expect(sizeOf('gif')).toEqual({ width: 801, height: 533 });
    expect(sizeOf('webm', 'square')).toEqual({ width: 1080, height: 1080 });
    expect([planOf('webm', 'view'), planOf('gif', 'view')].map((plan) => plan.isTrimmed)).toEqual([
      true,
      false,
    ]);
    // A shot keeps its aspect.
    expect(sizeOf('gif', 'square', 4 / 5)).toEqual({ width: 864, height: 1080 });
  });

  it('are refused if there are too many, or no rate', () => {
    const planOf = (to: number, rate: number) =>
      planMovie({ ...plainMovie, range: 'typed', from: 0, to, rate }, situation);
    expect(() => checkPlan(planOf(600, 60))).not.toThrow();
    expect(() => checkPlan(planOf(601, 60))).toThrow('at most 36,000 frames');
    expect(() => checkPlan(planOf(1, 0))).toThrow('frames a second');
    expect(() => checkPlan(planOf(1, NaN))).toThrow('frames a second');
  });
});
