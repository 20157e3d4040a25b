import { describe, expect, it } from 'vitest';
import { linesOf, plotOf, plotSize } from '../../../src/ui/deform-lab/sweep-plot.ts';

describe('the plot of a sweep', () => {
  it('has marks at round numbers, and always the values at rest', () => {
    const plot = plotOf([-180, 180], [92.5, 99]);
    expect(plot.angles).toEqual([-180, -90, 0, 90, 180]);
    expect(plot.percents).toEqual([94, 96, 98, 100]);
    const { left, right, top, bottom } = plot.area;
    expect(plot.across(-180)).toBe(left);
    expect(plot.across(180)).toBe(right);
    expect(plot.down(100)).toBe(top);
    expect(plot.down(92.5)).toBe(bottom);
    expect(right).toBeLessThan(plotSize.width);
  });

  it('draws what hardly changes on a scale of its own, and cuts off what explodes', () => {
    const flat = plotOf([0, 10], [100]);
    expect(flat.percents).toEqual([98, 99, 100, 101, 102]);
    expect(flat.down(100)).toBe((flat.area.top + flat.area.bottom) / 2);
    const wild = plotOf([0, 10], [-50, 1e6]);
    expect(wild.down(1e6)).toBe(wild.area.top);
    expect(wild.down(-50)).toBe(wild.area.bottom);
  });

  it('interrupts a line where there is no value', () => {
    const plot = plotOf([0, 4], [50, 100]);
    const lines = linesOf(plot, [0, 1, 2, 3, 4], [100, 50, null, null, 50]);
    expect(lines.map((line) => line.split(' ').length)).toEqual([2, 1]);
  });
});
