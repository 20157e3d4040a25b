import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  framingValues,
  normalizing,
  type Plot,
  plottedAt,
  plottedOf,
  timeAt,
  valueOf,
  xOf,
  yOf,
  zoomedValues,
} from '../../../src/ui/curve-editor/plot.ts';
import { valueMarks } from '../../../src/ui/curve-editor/value-axis.ts';
import { hinge, key, lineOf, plot } from './lines.ts';

const place = fc.double({ min: -1000, max: 1000, noNaN: true });

describe('the plot', () => {
  it('puts time to the right and value upward, and finds both back', () => {
    expect([xOf(plot, 1), yOf(plot, 0.5)]).toEqual([100, 50]);
    fc.assert(
      fc.property(place, place, (x, y) => {
        expect(xOf(plot, timeAt(plot, x))).toBeCloseTo(x, 8);
        expect(yOf(plot, plottedAt(plot, y))).toBeCloseTo(y, 8);
      }),
    );
  });

  it('is zoomed about a value, which stays where it is', () => {
    const values = zoomedValues(plot.values, 0.5, 0.5);
    expect(values).toEqual([-0.25, 0.75]);
    expect(yOf({ ...plot, values }, 0.5)).toBe(yOf(plot, 0.5));
  });

  it('frames a curve of no height too', () => {
    const [low, high] = framingValues([2, 2]);
    expect(low).toBeLessThan(2);
    expect(high).toBeGreaterThan(2);
  });

  it('stretches each curve to −1 and 1 where curves are fitted, and typed values are its own', () => {
    const line = lineOf(hinge(0, [key(0, 3, 'auto'), key(1, 7, 'auto'), key(2, 5)]), true);
    expect(plottedOf(line.scale, 3)).toBeCloseTo(-1, 12);
    expect(plottedOf(line.scale, 7)).toBeCloseTo(1, 12);
    expect(valueOf(line.scale, plottedOf(line.scale, 4.5))).toBeCloseTo(4.5, 12);
    expect(plottedOf(normalizing([4, 4]), 4)).toBe(0);
  });
});

describe('the axis of values', () => {
  const texts = (values: Plot['values'], unit: 'angle' | 'length'): string[] =>
    valueMarks({ values, height: 200 }, unit).map(({ text }) => text);

  it('is in degrees for angles, which do not wrap', () => {
    expect(texts([-Math.PI, 3.2 * Math.PI], 'angle')).toEqual([
      ...['-180°', '0°', '180°', '360°', '540°'],
    ]);
  });

  it('has round numbers for lengths, far apart enough to be read', () => {
    expect(texts([-1, 1], 'length')).toEqual([...['-1.0', '-0.5', '0.0', '0.5', '1.0']]);
    fc.assert(
      fc.property(
        fc.double({ min: -1e4, max: 1e4, noNaN: true }),
        fc.double({ min: 1e-4, max: 1e5, noNaN: true }),
        fc.constantFrom('angle', 'length'),
        (low, size, unit) => {
          const marks = valueMarks({ values: [low, low + size], height: 200 }, unit);
          expect(marks.length).toBeLessThanOrEqual(9);
          expect(new Set(marks.map(({ text }) => text)).size).toBe(marks.length);
        },
      ),
    );
  });
});
