import { describe, expect, it } from 'vitest';
import {
  type Figure,
  figureSide,
  panned,
  pathData,
  scaleBar,
  viewOfAll,
  viewOfJoint,
  zoomedAt,
} from '../../src/ui/deform-lab/figure-paths.ts';
import { figureSvg } from '../../src/ui/deform-lab/figure-svg.ts';

const square = { places: Float64Array.of(-1, -1, 3, -1, 3, 1, -1, 1), isClosed: true };
const stroke = { places: Float64Array.of(0, 0, 1, 1), isClosed: false };

const figure: Figure = {
  characterName: 'A & <b>',
  jointName: 'elbow',
  plane: { origin: [0, 0, 0], across: [1, 0, 0], up: [0, 1, 0], normal: [0, 0, 1], reach: 2 },
  outlines: [
    { role: 'rigid', label: 'Rigid parts', lines: [stroke], isPending: false },
    { role: 'blend', label: 'Linear blend', lines: [square], isPending: false },
    { role: 'third', label: 'Delta mush', lines: [], isPending: true },
  ],
};

describe('the drawing of a cutting figure', () => {
  it('has the joint in its middle, up upwards, and one scale in both directions', () => {
    const view = { center: [0, 0], half: 2 } as const;
    expect(viewOfJoint(figure).center).toEqual([0, 0]);
    expect(figureSide).toBe(300);
    expect(pathData([stroke], view)).toBe('M150 150L225 75');
    expect(pathData([square, stroke], view)).toBe('M75 225L375 225L375 75L75 75ZM150 150L225 75');
  });

  it('shows all outlines where that is asked for', () => {
    const { center, half } = viewOfAll(figure);
    expect(center).toEqual([1, 0]);
    expect(half).toBeGreaterThan(2);
    expect(half).toBeLessThan(2.5);
    const empty = { ...figure, outlines: [] };
    expect(viewOfAll(empty)).toEqual(viewOfJoint(empty));
  });

  it('stays where the pointer is when it is zoomed, and follows when it is moved', () => {
    const view = { center: [1, 2], half: 4 } as const;
    // The place at a quarter from the left and from above is (-1, 4).
    const near = zoomedAt(view, 0.5, [0.25, 0.25]);
    expect(near.half).toBe(2);
    expect([near.center[0] - near.half / 2, near.center[1] + near.half / 2]).toEqual([-1, 4]);
    expect(panned(view, [0.25, 0.5])).toEqual({ half: 4, center: [-1, 6] });
  });

  it('has a scale bar of a round length', () => {
    expect(scaleBar({ center: [0, 0], half: 1.5 })).toEqual({ pixels: 100, text: '1 unit' });
    expect(scaleBar({ center: [0, 0], half: 0.2 })).toEqual({ pixels: 75, text: '0.1 units' });
    expect(scaleBar({ center: [0, 0], half: 90 }).text).toBe('50 units');
  });

  it('is saved with a legend of what it shows, and names of files stay text', () => {
    const svg = figureSvg(figure, viewOfJoint(figure));
    expect(svg).toContain('A &amp; &lt;b&gt;, cut at elbow');
    expect(svg).not.toContain('<b>');
    expect(svg).toContain('>Rigid parts<');
    expect(svg).toContain('>Linear blend<');
    expect(svg).not.toContain('Delta mush');
    expect(svg.match(/stroke-dasharray/g)).toHaveLength(2);
  });
});
