import fc from 'fast-check';
import type {
  ChannelParts,
  ClipParts,
  Extrapolation,
  KeyParts,
  Quaternion,
  ScalarTarget,
  Tangent,
} from '../../../src/core/motion/clip-parts.ts';
import { DofKind } from '../../../src/core/skeleton.ts';

/** Objects as readers make them. */
function record<T>(model: { [K in keyof T]: fc.Arbitrary<T[K]> }): fc.Arbitrary<T> {
  return fc.record(model, { noNullPrototype: true });
}

const number = fc.double({ min: -1e18, max: 1e18, noNaN: true });
const small = fc.double({ min: -8, max: 8, noNaN: true });
const rule = fc.constantFrom<Extrapolation>(
  ...(['constant', 'linear', 'cycle', 'cycle_offset', 'bounce'] as const),
);
const tangent: fc.Arbitrary<Tangent> = fc.oneof(
  fc.constantFrom<Tangent>('flat', 'linear', 'smooth', 'auto', 'stepped'),
  number,
  fc.tuple(small, small, small).map((tcb) => ({ tcb })),
);

/** Times that are further apart than keys of one time. */
function timed<Value>(value: fc.Arbitrary<Value>): fc.Arbitrary<(Value & { time: number })[]> {
  const gap = fc.double({ min: 0.001, max: 1e3, noNaN: true });
  return fc.tuple(small, fc.array(fc.tuple(gap, value), { maxLength: 6 })).map(([start, keys]) => {
    let time = start;
    return keys.map(([gapBefore, key]) => ({ ...key, time: (time += gapBefore) }));
  });
}

const scalarKeys: fc.Arbitrary<KeyParts[]> = timed(
  record({ value: number, tangentIn: tangent, tangentOut: tangent }),
);

const quaternion: fc.Arbitrary<Quaternion> = fc
  .tuple(small, small, small, small)
  .filter((values) => Math.hypot(...values) > 1e-3)
  .map((values) => {
    const length = Math.hypot(...values);
    return values.map((value) => value / length) as unknown as Quaternion;
  });

const targets: readonly ScalarTarget[] = [
  ...([0, 1, 2] as const).map(
    (axis) => ({ of: 'value', joint: 0, kind: DofKind.slide, axis }) as const,
  ),
  ...([0, 1, 2] as const).map(
    (axis) => ({ of: 'value', joint: 1, kind: DofKind.hinge, axis }) as const,
  ),
  ...[0, 1, 2, 3].map((morph) => ({ of: 'morph', morph }) as const),
  ...(['x', 'y', 'z', 'weight'] as const).map((value) => ({ of: 'pin', joint: 3, value }) as const),
];

const scalarChannels: fc.Arbitrary<ChannelParts[]> = fc
  .subarray([...targets])
  .chain((chosen) =>
    fc.tuple(
      ...chosen.map((target) =>
        record({ target: fc.constant(target), before: rule, after: rule, keys: scalarKeys }),
      ),
    ),
  );

const rotations: fc.Arbitrary<ChannelParts> = record({
  target: fc
    .constantFrom('slerp' as const, 'squad' as const)
    .map((curve) => ({ of: 'rotation' as const, joint: 2, curve })),
  before: rule,
  after: rule,
  keys: timed(record({ value: quaternion })),
});

/** Channels of kinds that nothing knows. */
const unread = fc.array(
  fc
    .tuple(fc.string(), fc.array(fc.array(number)))
    .map(([shape, keys]) => ({ target: { shape }, keys })),
  { minLength: 1, maxLength: 3 },
);

/** Clips of the character in `mover.ts` with every kind of target, tangent and extrapolation. */
export const clips: fc.Arbitrary<ClipParts> = record({
  times: fc.tuple(small, small),
  fps: fc.oneof(fc.constantFrom(24, 25, 30, 60), fc.double({ min: 1, max: 1000, noNaN: true })),
  scalar: scalarChannels,
  rotation: fc.option(rotations, { nil: undefined }),
  unread: fc.option(unread, { nil: undefined }),
}).map(({ times, fps, scalar, rotation, unread: others }) => ({
  file: 'wave.motion.json',
  name: 'wave',
  start: Math.min(...times),
  end: Math.max(...times),
  fps,
  channels: rotation ? [...scalar, rotation] : scalar,
  ...(others && { unread: others }),
}));
