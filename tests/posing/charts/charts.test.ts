import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Quaternion } from '../../../src/core/motion/clip-parts.ts';
import { isSingular, type RotationChart } from '../../../src/posing/charts/chart.ts';
import { chartCurve, valuesAt } from '../../../src/posing/charts/chart-curve.ts';
import { eulerChart } from '../../../src/posing/charts/euler-chart.ts';
import { aboutAxis, exponential, product } from '../../../src/posing/charts/quaternions.ts';
import { rotationVectorChart } from '../../../src/posing/charts/rotation-vector-chart.ts';
import { swingTwistChart } from '../../../src/posing/charts/swing-twist-chart.ts';

const [x, y, z] = [
  { name: 'X', axis: [1, 0, 0] },
  { name: 'Y', axis: [0, 1, 0] },
  { name: 'Z', axis: [0, 0, 1] },
] as const;
const bone = [0.6, -0.48, 0.64] as const; // a unit vector in no coordinate plane

const charts: readonly (readonly [string, RotationChart])[] = [
  ['Euler Rx Ry Rz', eulerChart([x, y, z])],
  ['Euler Rz Ry Rx', eulerChart([z, y, x])],
  ['Euler Ry Rx Rz', eulerChart([y, x, z])],
  ['swing and twist', swingTwistChart(bone)],
  ['rotation vector', rotationVectorChart],
];
const eulerXyz = charts[0]![1];

/** Rounding of a few products of unit quaternions. */
const roundTrip = 1e-9;
/** Euler angles are read as if locked where the cosine of the middle one is below 1e-6. */
const lockedStretch = 0.9e6;
const lockedRoundTrip = 2e-6;
// A failure is told as it was found, since these numbers would shrink in very many steps.
fc.configureGlobal({ endOnFailure: true });
const degree = Math.PI / 180;

const part = fc.double({ min: -1, max: 1, noNaN: true });
const rotations = fc
  .tuple(part, part, part, part)
  .filter((q) => Math.hypot(...q) > 0.1)
  .map((q): Quaternion => {
    const length = Math.hypot(...q);
    return [q[0] / length, q[1] / length, q[2] / length, q[3] / length];
  });
const nears = fc.tuple(...[0, 1, 2].map(() => fc.double({ min: -12, max: 12, noNaN: true })));

/** The angle between two rotations. */
function turnBetween(a: Quaternion, b: Quaternion): number {
  const [cx, cy, cz, cw] = product([-a[0], -a[1], -a[2], a[3]], b);
  return 2 * Math.atan2(Math.hypot(cx, cy, cz), Math.abs(cw));
}

describe.each(charts)('the chart of %s', (_, chart) => {
  it('gives back the rotation that it read, wherever the numbers were before', () => {
    fc.assert(
      fc.property(rotations, nears, (rotation, near) => {
        const values = chart.read(rotation, near);
        const isLocked = chart.stretchAt(values) > lockedStretch;
        const bound = isLocked ? lockedRoundTrip : roundTrip;
        expect(turnBetween(rotation, chart.rotationOf(values))).toBeLessThan(bound);
      }),
    );
  });

  it('reads the same numbers from both quaternions of a rotation', () => {
    fc.assert(
      fc.property(rotations, nears, (q, near) => {
        const other: Quaternion = [-q[0], -q[1], -q[2], -q[3]];
        const values = chart.read(q, near);
        chart.read(other, values).forEach((value, i) => expect(value).toBeCloseTo(values[i]!, 6));
      }),
    );
  });

  it('keeps its numbers where they are already those of the rotation', () => {
    fc.assert(
      fc.property(nears, (values) => {
        fc.pre(!isSingular(chart, values));
        const read = chart.read(chart.rotationOf(values), values);
        read.forEach((value, i) => expect(value).toBeCloseTo(values[i]!, 7));
      }),
    );
  });

  it('never stretches a small turn by more than it says', () => {
    const step = 1e-6;
    fc.assert(
      fc.property(nears, (values) => {
        const stretch = chart.stretchAt(values);
        fc.pre(stretch < 8);
        const rotation = chart.rotationOf(values);
        const changed = [0, 1, 2].map((axis) => {
          const turn = aboutAxis(
            [0, 1, 2].map((i) => (i === axis ? 1 : 0)),
            step,
          );
          const after = chart.read(product(turn, rotation), values);
          return after.map((value, i) => (value - values[i]!) / step);
        });
        // The most that a unit turn does to the numbers' fastest direction.
        const rates = [0, 1, 2].map((i) => Math.hypot(...changed.map((each) => each[i]!)));
        expect(Math.max(...rates)).toBeLessThan(stretch * 1.001 + 1e-4);
      }),
    );
  });

  it('draws any smooth motion without a jump, except where it is singular', () => {
    const waves = fc.array(fc.tuple(nears, fc.double({ min: 0.2, max: 2, noNaN: true })), {
      minLength: 1,
      maxLength: 2,
    });
    fc.assert(
      fc.property(waves, (parts) => {
        const times = Array.from({ length: 2001 }, (_, i) => i / 800);
        const motion = times.map((time) =>
          parts
            .map(([size, speed]) =>
              exponential(size.map((each) => each * 0.3 * Math.sin(speed * time))),
            )
            .reduce(product),
        );
        const { values } = chartCurve(chart, { times, rotations: motion });
        values.slice(1).forEach((after, i) => {
          const before = values[i]!;
          if (isSingular(chart, before) || isSingular(chart, after)) return;
          const jump = Math.max(...after.map((value, axis) => Math.abs(value - before[axis]!)));
          expect(jump).toBeLessThan(Math.PI / 4);
        });
      }),
      { numRuns: 15 },
    );
  });
});

describe('unwrapped curves', () => {
  const times = Array.from({ length: 301 }, (_, i) => i / 100);
  const turning = (axis: readonly number[]) => times.map((time) => aboutAxis(axis, Math.PI * time));

  it('count whole turns: 540° about an axis are 540°', () => {
    const drawn = chartCurve(eulerXyz, { times, rotations: turning([1, 0, 0]) });
    expect(drawn.values.at(-1)![0]).toBeCloseTo(3 * Math.PI, 9);
    const vector = chartCurve(rotationVectorChart, { times, rotations: turning(bone) });
    vector.values
      .at(-1)!
      .forEach((value, i) => expect(value).toBeCloseTo(3 * Math.PI * bone[i]!, 9));
    const twist = chartCurve(swingTwistChart(bone), { times, rotations: turning(bone) });
    expect(twist.values.at(-1)![0]).toBeCloseTo(0, 9);
    expect(twist.values.at(-1)![2]).toBeCloseTo(3 * Math.PI, 9);
  });

  it('are the numbers that are stored, if they are given', () => {
    const stored = times.map((time) => [7 * time, 0, 0]);
    const drawn = chartCurve(eulerXyz, { times, rotations: turning([1, 0, 0]) }, stored);
    expect(drawn.values).toBe(stored);
  });

  it('have values between their samples, on the same branch', () => {
    const drawn = chartCurve(eulerXyz, { times, rotations: turning([0, 0, 1]) });
    const at = 2.7153;
    const [, , angle] = valuesAt(drawn, at, aboutAxis([0, 0, 1], Math.PI * at));
    expect(angle).toBeCloseTo(Math.PI * at, 9);
  });
});

describe('singular places', () => {
  const times = Array.from({ length: 401 }, (_, i) => i / 100);

  it('are shaded about gimbal lock: where the middle angle is within 5° of ±90°', () => {
    // The middle angle goes from 0° to 120° in four seconds, at a constant 20° and 10° of the others.
    const rotations = times.map((time) =>
      eulerXyz.rotationOf([20 * degree, 30 * degree * time, 10 * degree]),
    );
    const { singular, chart, values } = chartCurve(eulerXyz, { times, rotations });
    expect(singular).toHaveLength(1);
    expect(singular[0]![0]).toBeCloseTo(85 / 30, 2);
    expect(singular[0]![1]).toBeCloseTo(95 / 30, 2);
    expect(chart.foldText(values[300]!)).toBe('Gimbal lock: X and Z turn about one axis');
    // Through the lock the numbers go on.
    expect(values.at(-1)![1]).toBeCloseTo(120 * degree, 6);
  });

  it('are shaded about a swing by half a turn, where the twist is kept', () => {
    const chart = swingTwistChart([0, 1, 0]);
    const rotations = times.map((time) => aboutAxis([0, 0, 1], 60 * degree * time));
    const { singular, values } = chartCurve(chart, { times, rotations });
    expect(singular).toHaveLength(1);
    const [from, to] = singular[0]!;
    expect((from + to) / 2).toBeCloseTo(3, 1);
    for (const each of values) expect(each[2]).toBeCloseTo(0, 6);
    expect(Math.hypot(values.at(-1)![0]!, values.at(-1)![1]!)).toBeCloseTo(240 * degree, 6);
    expect(chart.foldText(values[300]!)).toMatch(/half a turn/);
    expect(chart.foldText([2 * Math.PI, 0, 0])).toMatch(/full turn/);
  });

  it('are shaded about a full turn of the rotation vector, and not about none', () => {
    const rotations = times.map((time) => aboutAxis(bone, 100 * degree * time));
    const { singular } = chartCurve(rotationVectorChart, { times, rotations });
    expect(singular).toHaveLength(1);
    const [from, to] = singular[0]!;
    expect((from + to) / 2).toBeCloseTo(3.6, 1);
    expect(isSingular(rotationVectorChart, [0, 0, 0])).toBe(false);
    expect(rotationVectorChart.foldText([6.2, 0, 0])).toMatch(/full turn/);
  });

  it('does not count for joints with fewer than three hinges', () => {
    const knee = eulerChart([x]);
    expect(knee.read(aboutAxis([1, 0, 0], 2), [0])).toEqual([expect.closeTo(2, 12)]);
    expect(isSingular(knee, [Math.PI / 2])).toBe(false);
    const ankle = eulerChart([x, z]);
    const [first, second] = ankle.read(ankle.rotationOf([0.3, -0.9]), [0, 0]);
    expect(first).toBeCloseTo(0.3, 12);
    expect(second).toBeCloseTo(-0.9, 12);
  });
});
