import fc from 'fast-check';
import type {
  ClipParts,
  Extrapolation,
  KeyParts,
  Quaternion,
  RotationChannelParts,
  RotationCurve,
  ScalarChannelParts,
  Tangent,
} from '../../src/core/motion/clip-parts.ts';

const number = (minimum: number, maximum: number) =>
  fc.double({ min: minimum, max: maximum, noNaN: true });

/** Tangents of every kind. */
export const tangents: Readonly<Record<string, fc.Arbitrary<Tangent>>> = {
  flat: fc.constant('flat'),
  linear: fc.constant('linear'),
  smooth: fc.constant('smooth'),
  auto: fc.constant('auto'),
  stepped: fc.constant('stepped'),
  fixed: number(-9, 9),
  tcb: fc.tuple(number(-1, 1), number(-1, 1), number(-1, 1)).map((tcb) => ({ tcb })),
};

export const anyTangent = fc.oneof(...Object.values(tangents));

/** Times that are at least 0.02 s apart. */
function timesOf(count: number): fc.Arbitrary<readonly number[]> {
  return fc
    .tuple(number(-3, 3), fc.array(number(0.02, 2), { minLength: count - 1, maxLength: count - 1 }))
    .map(([start, gaps]) => {
      let time = start;
      return [start, ...gaps.map((gap) => (time += gap))];
    });
}

function keysOf(
  tangent: fc.Arbitrary<Tangent>,
  { fewest = 1, most = 7 } = {},
): fc.Arbitrary<readonly KeyParts[]> {
  return fc.integer({ min: fewest, max: most }).chain((count) =>
    fc
      .tuple(
        timesOf(count),
        fc.array(fc.tuple(number(-10, 10), tangent, tangent), {
          minLength: count,
          maxLength: count,
        }),
      )
      .map(([times, rest]) =>
        rest.map(([value, tangentIn, tangentOut], i) => ({
          time: times[i]!,
          value,
          tangentIn,
          tangentOut,
        })),
      ),
  );
}

const extrapolations: readonly Extrapolation[] = [
  'constant',
  'linear',
  'cycle',
  'cycle_offset',
  'bounce',
];

const rule = fc.constantFrom(...extrapolations);

export function scalarChannels(
  tangent: fc.Arbitrary<Tangent> = anyTangent,
  limits: { readonly fewest?: number; readonly most?: number } = {},
): fc.Arbitrary<ScalarChannelParts> {
  return fc.record({
    target: fc.constant({ of: 'morph', morph: 0 } as const),
    before: rule,
    after: rule,
    keys: keysOf(tangent, limits),
  });
}

/** Unit quaternions, none of them preferred. */
const rotations: fc.Arbitrary<Quaternion> = fc
  .tuple(number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1))
  .filter((parts) => Math.hypot(...parts) > 0.1)
  .map((parts) => {
    const length = Math.hypot(...parts);
    return [parts[0] / length, parts[1] / length, parts[2] / length, parts[3] / length] as const;
  });

export function rotationChannels(
  curve: RotationCurve,
  { fewest = 2, joint = 0 } = {},
): fc.Arbitrary<RotationChannelParts> {
  return fc.integer({ min: fewest, max: 6 }).chain((count) =>
    fc
      .tuple(
        timesOf(count),
        fc.array(rotations, { minLength: count, maxLength: count }),
        rule,
        rule,
      )
      .map(([times, values, before, after]) => ({
        target: { of: 'rotation', joint, curve } as const,
        before,
        after,
        keys: values.map((value, i) => ({ time: times[i]!, value })),
      })),
  );
}

export function clipOf(...channels: ClipParts['channels']): ClipParts {
  return { file: 'test.anim', name: 'test', start: 0, end: 4, fps: 30, channels };
}
