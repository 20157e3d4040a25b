import { describe, expect, it } from 'vitest';
import { rulerMarks } from '../../../src/ui/timeline/marks.ts';
import { timeText } from '../../../src/ui/timeline/timeline-state.ts';

const labels = (...parameters: Parameters<typeof rulerMarks>) =>
  rulerMarks(...parameters).flatMap(({ text }) => (text === '' ? [] : text));

describe('the marks of the ruler', () => {
  it('are at round seconds', () => {
    expect(labels([-0.1, 2.1], 600, 30, 'seconds')).toEqual([
      ...['0.0', '0.5', '1.0', '1.5', '2.0'],
    ]);
    expect(labels([-20, 100], 800, 30, 'seconds')).toEqual([
      ...['-20', '-10', '0', '10', '20', '30', '40', '50', '60', '70', '80', '90', '100'],
    ]);
  });

  it('are at frames, never between them', () => {
    expect(labels([0, 1], 300, 24, 'frames')).toEqual(['0', '5', '10', '15', '20']);
    const close = rulerMarks([0, 0.1], 1000, 30, 'frames');
    expect(close.map(({ text }) => text)).toEqual(['0', '1', '2', '3']);
  });

  it('stand where their times are, with room for the labels', () => {
    for (const length of [0.05, 0.7, 3, 42, 1000]) {
      const marks = rulerMarks([1, 1 + length], 700, 30, 'seconds');
      const labeled = marks.filter(({ text }) => text !== '');
      labeled.forEach(({ x, text }) =>
        expect(x).toBeCloseTo(((Number(text) - 1) / length) * 700, 3),
      );
      const gaps = labeled.slice(1).map(({ x }, i) => x - labeled[i]!.x);
      expect(Math.min(...gaps, Infinity)).toBeGreaterThanOrEqual(56 - 1e-6);
      expect(marks.length).toBeLessThanOrEqual(102);
    }
  });

  it('are none before the ruler has a width', () => {
    expect(rulerMarks([0, 1], 0, 30, 'seconds')).toEqual([]);
  });
});

describe('a time', () => {
  it('is written in seconds or as a frame, which may lie between two', () => {
    expect(timeText(0.5, 30, 'seconds')).toBe('0.50 s');
    expect(timeText(0.5, 30, 'frames')).toBe('15');
    expect(timeText(0.51, 30, 'frames')).toBe('15.3');
  });
});
