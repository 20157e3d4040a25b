import { describe, expect, it } from 'vitest';
import { noKeys } from '../../../src/core/motion/key-selection.ts';
import { oneKey } from '../../../src/ui/curve-editor/curve-edits.ts';
import { handlesOf } from '../../../src/ui/curve-editor/handles.ts';
import { hitAt, keysInBox, type Shown, shownBox } from '../../../src/ui/curve-editor/hits.ts';
import { sampleLine } from '../../../src/ui/curve-editor/line-samples.ts';
import { handlePlace, visibleBox } from '../../../src/ui/curve-editor/scale-box.ts';
import { hinge, key, lineOf, plot } from './lines.ts';

const line = lineOf(hinge(0, [key(1, 0), key(2, 0.5), key(3, 0)]));
const other = lineOf(hinge(1, [key(1, -0.8), key(3, -0.8)]));
const shown: Shown = { lines: [line, other], locked: new Set(), selection: noKeys, plot };
const middle = { x: 200, y: 50 };

describe('what the pointer meets', () => {
  it('is a key within reach, else a line, else nothing', () => {
    expect(hitAt(shown, { x: 205, y: 53 }, 7)).toEqual({ of: 'key', line, at: 1 });
    expect(hitAt(shown, { x: 200, y: 180 }, 7)).toEqual({ of: 'line', line: other });
    expect(hitAt(shown, { x: 200, y: 130 }, 7)).toEqual({ of: 'nothing' });
  });

  it('is a line where it is steep, and beyond its keys', () => {
    const steep = lineOf(hinge(0, [key(1, -1, 'linear'), key(1.02, 1, 'linear')]));
    expect(hitAt({ ...shown, lines: [steep] }, { x: 101, y: 100 }, 5).of).toBe('line');
    expect(hitAt(shown, { x: 380, y: 100 }, 5)).toEqual({ of: 'line', line });
  });

  it('is nothing of a locked curve', () => {
    const locked = { ...shown, locked: new Set([line.key]) };
    expect(hitAt(locked, middle, 7)).toEqual({ of: 'nothing' });
  });

  it('is a handle of a selected key, and a corner of the box around several', () => {
    const one = { ...shown, selection: oneKey(line.key, 2) };
    const [before, after] = handlesOf(line, 1, plot);
    expect(hitAt(one, after!.end, 7)).toEqual({ of: 'handle', handle: after });
    expect(hitAt(one, before!.end, 7)).toMatchObject({ of: 'handle', handle: { side: 'in' } });
    expect(shownBox(one)).toBeNull();
    const two = { ...shown, selection: new Map([[line.key, [1, 2]]]) };
    const corner = handlePlace(shownBox(two)!, { across: 1, down: -1 });
    expect(hitAt(two, corner, 7)).toMatchObject({ of: 'box', handle: { across: 1, down: -1 } });
  });

  it('is by a finger the nearest of a key and the corners of its box', () => {
    const two = { ...shown, selection: new Map([[line.key, [1, 2]]]) };
    const { x, y } = handlePlace(shownBox(two)!, { across: -1, down: 1 });
    expect(hitAt(two, { x, y }, 22)).toMatchObject({ of: 'box', handle: { across: -1, down: 1 } });
    expect(hitAt(two, { x: x + 12, y: y - 12 }, 22)).toEqual({ of: 'key', line, at: 0 });
  });

  it('is a corner of the box at the edge of the plot while its keys are out of sight', () => {
    const two = { ...shown, selection: new Map([[line.key, [1, 3]]]) };
    const near = { ...plot, time: [2, 3.5] as const };
    const box = visibleBox(shownBox({ ...two, plot: near })!, near)!;
    expect(box.left).toBeGreaterThan(0);
    expect(hitAt({ ...two, plot: near }, { x: box.left, y: box.bottom }, 7)).toMatchObject({
      ...{ of: 'box', handle: { across: -1, down: 1 } },
    });
    const away = { ...plot, time: [8, 9] as const };
    expect(visibleBox(shownBox({ ...two, plot: away })!, away)).toBeNull();
  });

  it('in a rectangle is each key within it, of every curve that is not locked', () => {
    const box = { left: 150, right: 320, top: 0, bottom: 200 };
    expect(keysInBox(shown, box)).toEqual(
      new Map([
        [line.key, [2, 3]],
        [other.key, [3]],
      ]),
    );
    expect(keysInBox({ ...shown, locked: new Set([line.key]) }, box)).toEqual(oneKey(other.key, 3));
  });
});

describe('a line in the plot', () => {
  it('has at most one sample a column, and meets its keys', () => {
    const runs = sampleLine(line, plot);
    expect(runs.map(({ isBeyond }) => isBeyond)).toEqual([true, false, true]);
    const points = runs.flatMap((run) => run.points);
    expect(points.length).toBeLessThanOrEqual(plot.width + 6);
    expect(runs[1]!.points[0]).toEqual({ x: 100, y: 100 });
    expect(runs[1]!.points.at(-1)).toEqual({ x: 300, y: 100 });
    expect(runs[2]!.points.every(({ y }) => y === 100)).toBe(true);
  });

  it('is beyond its keys alone where these are out of sight', () => {
    const runs = sampleLine(line, { ...plot, time: [4, 8] });
    expect(runs.map(({ isBeyond }) => isBeyond)).toEqual([true]);
  });
});
