import { describe, expect, it } from 'vitest';
import { labOf } from '../../../src/core/color-difference.ts';
import type { Skin } from '../../../src/core/skin.ts';
import { jointColors } from '../../../src/skinning/weights/joint-colors.ts';
import {
  belowColor,
  countColors,
  errorRamp,
  excessRamp,
  hueRamp,
  shortRamp,
  zeroColor,
} from '../../../src/skinning/weights/ramps.ts';
import {
  vertexColors,
  type WeightSubject,
  type WeightViewId,
} from '../../../src/skinning/weights/views.ts';

/** Three joints in a row, and points with these weights of them. */
function subjectOf(rows: readonly (readonly number[])[], change: Partial<WeightSubject> = {}) {
  const start = rows.reduce((starts, row) => [...starts, starts.at(-1)! + row.length], [0]);
  const skin: Skin = {
    start: Uint32Array.from(start),
    entries: Uint16Array.from(rows.flatMap((row) => row.map((_, joint) => joint))),
    weights: Float32Array.from(rows.flat()),
    paletteJoint: Uint16Array.of(0, 1, 2),
    jointFromBind: new Float64Array(48),
    normals: 'blended',
  };
  const colors = jointColors({ jointCount: 3, parents: Int16Array.of(-1, 0, 1) });
  return { skin, colors, joint: null, errors: null, largestError: 0, ...change };
}

function colorsOf(id: WeightViewId, subject: WeightSubject): number[][] {
  const pointCount = subject.skin.start.length - 1;
  const bytes = vertexColors(
    id,
    subject,
    Uint32Array.from({ length: pointCount }, (_, i) => i),
  );
  return Array.from({ length: pointCount }, (_, i) => [...bytes.subarray(i * 4, i * 4 + 3)]);
}

const lightness = (bytes: readonly [number, number, number]): number => labOf(bytes)[0];

describe('every ramp', () => {
  it('darkens evenly, step by step, and never shows the color of zero', () => {
    const hues = Array.from({ length: 12 }, (_, index) => hueRamp(index * 30));
    for (const ramp of [errorRamp, shortRamp, excessRamp, ...hues]) {
      const steps = ramp.map(lightness);
      expect(steps[0]! - steps.at(-1)!).toBeGreaterThan(40);
      const even = (steps[0]! - steps.at(-1)!) / (steps.length - 1);
      for (let i = 1; i < steps.length; i++) {
        const step = steps[i - 1]! - steps[i]!;
        // Bytes are whole numbers, which is a third of a step or more.
        expect(Math.abs(step - even), `step ${i}`).toBeLessThan(0.5);
      }
      expect(ramp).not.toContainEqual(zeroColor);
    }
  });
});

describe('the weights of one joint', () => {
  it('have their place in the ramp; zero, however written, and less have colors of their own', () => {
    const subject = subjectOf([[1, 0], [0.5, 0.5], [1e-6, 1], [0, 1], [-0.25, 1], [1.5]], {
      joint: 0,
    });
    const ramp = hueRamp(subject.colors.hues[0]!);
    const colors = colorsOf('joint', subject);
    expect(colors[0]).toEqual(ramp.at(-1));
    expect(colors[1]).toEqual(ramp[128]);
    expect(colors[2], 'the least weight').toEqual(ramp[0]);
    expect(colors[3]).toEqual(zeroColor);
    expect(colors[4]).toEqual(belowColor);
    expect(colors[5]).toEqual(ramp.at(-1));
    // The smallest weight must not look like none.
    expect(lightness(ramp[0]!) - lightness(zeroColor)).toBeGreaterThan(40);
  });

  it('are all none until a joint is chosen', () => {
    expect(colorsOf('joint', subjectOf([[1], [0.5, 0.5]]))).toEqual([zeroColor, zeroColor]);
  });
});

describe('the other views', () => {
  it('count the weights that are not zero', () => {
    const nine = new Array<number>(9).fill(1 / 9);
    const subject = subjectOf([[], [1, 0, 0], [0.5, 0.5, 0], [0.25, 0.25, 0.5], nine]);
    const colors = colorsOf('count', subject);
    expect(colors).toEqual([0, 1, 2, 3, 9].map((count) => countColors[count]));
    expect(new Set(countColors.map(String)).size).toBe(10);
  });

  it('tell sums that fall short from those that exceed, by powers of ten', () => {
    const subject = subjectOf([[1], [0.5, 0.25], [1.25], [1 - 1 / 256], [1 + 2 ** -21], []]);
    const colors = colorsOf('sum', subject);
    const part = (error: number): number => Math.round(((Math.log10(error) + 6) / 6) * 255);
    expect(colors).toEqual([
      zeroColor,
      shortRamp[part(0.25)],
      excessRamp[part(0.25)],
      shortRamp[part(1 / 256)],
      zeroColor,
      shortRamp.at(-1),
    ]);
  });

  it('color errors from none to the largest', () => {
    const errors = Float32Array.of(0, 0.5, 1, 0.25);
    const subject = subjectOf([[1], [1], [1], [1]], { errors, largestError: 1 });
    expect(colorsOf('error', subject)).toEqual([
      zeroColor,
      errorRamp[128],
      errorRamp.at(-1),
      errorRamp[64],
    ]);
    expect(colorsOf('error', subjectOf([[1]]))).toEqual([zeroColor]);
  });

  it('leave what follows nothing gray, and negative weights out of the mean', () => {
    const subject = subjectOf([[], [-0.5, 1], [1, 0], [0, 2]]);
    const { bytes } = subject.colors;
    const own = (joint: number): number[] => [...bytes.subarray(joint * 3, joint * 3 + 3)];
    expect(colorsOf('joints', subject)).toEqual([zeroColor, own(1), own(0), own(1)]);
  });

  it('give the copies of a point, which seams make, its color', () => {
    const subject = subjectOf([[1], [0, 1]]);
    const bytes = vertexColors('joints', subject, Uint32Array.of(0, 1, 1, 0));
    expect(bytes.subarray(8, 16)).toEqual(
      Uint8Array.from([...bytes.subarray(4, 8), ...bytes.subarray(0, 4)]),
    );
  });
});
