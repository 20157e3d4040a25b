import { expect, it } from 'vitest';
import { channelFor, evaluateChannel } from '../../src/core/motion/channel.ts';
import type { Quaternion, RotationCurve, Tangent, Tcb } from '../../src/core/motion/clip-parts.ts';
import { evaluateRotation, rotationChannelFor } from '../../src/core/motion/rotation-channel.ts';
import { largestDifference } from '../support/compare.ts';
import { describeWithShared, sharedJson } from './shared-material.ts';

interface Curve {
  readonly v: readonly number[];
}

interface Curves {
  readonly keys: readonly (readonly [number, number])[];
  readonly times: readonly number[];
  readonly curves: Readonly<Record<string, Curve | undefined>> & {
    readonly tcb: {
      readonly cases: readonly (Curve & {
        readonly tension: number;
        readonly continuity: number;
        readonly bias: number;
      })[];
    };
  };
}

/** The references are computed in float64. */
const tolerance = 1e-6;

describeWithShared('the splines of the reference', ['reference/splines/scalar.json'], () => {
  const { keys, times, curves } = sharedJson('reference/splines/scalar.json') as Curves;

  function sampled(tangent: Tangent): readonly number[] {
    const channel = channelFor({
      target: null,
      before: 'constant',
      after: 'constant',
      keys: keys.map(([time, value]) => ({
        time,
        value,
        tangentIn: tangent,
        tangentOut: tangent,
      })),
    });
    return times.map((time) => evaluateChannel(channel, time));
  }

  it.each<[string, Tangent]>([
    ['catmull_rom_timed', 'smooth'],
    ['linear', 'linear'],
    ['flat', 'flat'],
    ['monotone_fritsch_butland_pchip', 'auto'],
  ])('%s', (name, tangent) => {
    // "linear" tangents bend at keys but are straight lines between them.
    expect(largestDifference(sampled(tangent), curves[name]!.v)).toBeLessThan(tolerance);
  });

  it('tension, continuity and bias', () => {
    expect(curves.tcb.cases.length).toBeGreaterThan(3);
    for (const { tension, continuity, bias, v } of curves.tcb.cases) {
      const tcb: Tcb = [tension, continuity, bias];
      expect(largestDifference(sampled({ tcb }), v), tcb.join(' ')).toBeLessThan(tolerance);
    }
  });

  it('differs from the curve that ignores how far keys are apart', () => {
    const uniform = curves.catmull_rom_uniform!.v;
    expect(largestDifference(sampled('smooth'), uniform)).toBeGreaterThan(0.01);
  });
});

/** w x y z */
type Reference = readonly (readonly [number, number, number, number])[];

interface RotationCurves {
  readonly keys: Reference;
  readonly u: readonly number[];
  readonly slerp: Reference;
  readonly squad: Reference;
  readonly squad_controls: Reference;
}

describeWithShared('rotations of the reference', ['reference/splines/quaternion.json'], () => {
  const reference = sharedJson('reference/splines/quaternion.json') as RotationCurves;

  const compiled = (curve: RotationCurve) =>
    rotationChannelFor({
      target: { of: 'rotation', joint: 0, curve },
      before: 'constant',
      after: 'constant',
      keys: reference.keys.map(([w, x, y, z], time) => ({ time, value: [x, y, z, w] })),
    });

  it.each<RotationCurve>(['slerp', 'squad'])('%s', (curve) => {
    const channel = compiled(curve);
    const rotation = new Float64Array(4);
    expect(reference.u.length).toBeGreaterThan(20);
    reference.u.forEach((time, i) => {
      evaluateRotation(channel, time, rotation);
      const found = [...rotation] as unknown as Quaternion;
      expect(distanceUpToSign(found, reference[curve][i]!), String(time)).toBeLessThan(tolerance);
    });
  });

  it('the control points of a squad', () => {
    const { controls } = compiled('squad');
    reference.squad_controls.forEach((expected, i) => {
      const found = [...controls.subarray(i * 4, i * 4 + 4)] as unknown as Quaternion;
      expect(distanceUpToSign(found, expected)).toBeLessThan(tolerance);
    });
  });
});

function distanceUpToSign(
  [x, y, z, w]: Quaternion,
  expected: readonly [number, number, number, number],
): number {
  const found = [w, x, y, z];
  const opposite = found.map((value) => -value);
  return Math.min(largestDifference(found, expected), largestDifference(opposite, expected));
}
