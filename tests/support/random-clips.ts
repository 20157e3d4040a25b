import fc from 'fast-check';
import type { Character } from '../../src/core/character.ts';
import type {
  ChannelParts,
  ChannelTarget,
  ClipParts,
  Extrapolation,
  Quaternion,
  RotationChannelParts,
  ScalarChannelParts,
  ScalarTarget,
  Tangent,
} from '../../src/core/motion/clip-parts.ts';
import { channelKey, pinValues } from '../../src/core/motion/targets.ts';
import { DofKind } from '../../src/core/skeleton.ts';

const number = fc.double({ min: -1e9, max: 1e9, noNaN: true });

const tangent: fc.Arbitrary<Tangent> = fc.oneof(
  fc.constantFrom('flat', 'linear', 'smooth', 'auto', 'stepped'),
  number,
  fc.tuple(number, number, number).map((tcb) => ({ tcb })),
);

const extrapolation = fc.constantFrom<Extrapolation>(
  ...(['constant', 'linear', 'cycle', 'cycle_offset', 'bounce'] as const),
);

const rotation = fc.tuple(number, number, number, number).map(([x, y, z, w]): Quaternion => {
  const length = Math.hypot(x, y, z, w);
  return length > 1e-9 ? [x / length, y / length, z / length, w / length] : [0, 0, 0, 1];
});

function atTimes<Key>(key: Record<keyof Key, fc.Arbitrary<unknown>>): fc.Arbitrary<readonly Key[]> {
  const keys = fc.record({ time: number, ...key }) as fc.Arbitrary<Key & { readonly time: number }>;
  return fc
    .uniqueArray(keys, { maxLength: 5, selector: ({ time }) => time })
    .map((each) => each.sort((a, b) => a.time - b.time));
}

/** Every kind of target, of joints and morphs that the character has and a few that it has not. */
function targetsOf({ skeleton, morphs }: Character): fc.Arbitrary<ChannelTarget | null> {
  const joint = fc.nat(skeleton.jointCount + 1);
  const scalars: fc.Arbitrary<ScalarTarget>[] = [
    fc.record({
      of: fc.constant('value' as const),
      joint,
      kind: fc.constantFrom(DofKind.slide, DofKind.hinge),
      axis: fc.constantFrom(0, 1, 2),
    }),
    fc.record({ of: fc.constant('morph' as const), morph: fc.nat(morphs.length + 1) }),
    fc.record({ of: fc.constant('pin' as const), joint, value: fc.constantFrom(...pinValues) }),
  ];
  const turned = fc.record({
    of: fc.constant('rotation' as const),
    joint,
    curve: fc.constantFrom('slerp' as const, 'squad' as const),
  });
  return fc.oneof(...scalars, turned, fc.constant(null));
}

function channelsOf(character: Character): fc.Arbitrary<ChannelParts> {
  const ends = { before: extrapolation, after: extrapolation };
  return targetsOf(character).chain((target): fc.Arbitrary<ChannelParts> => {
    if (target?.of === 'rotation') {
      const keys = atTimes<RotationChannelParts['keys'][number]>({ time: number, value: rotation });
      return fc.record({ target: fc.constant(target), ...ends, keys });
    }
    const keys = atTimes<ScalarChannelParts['keys'][number]>({
      time: number,
      value: number,
      tangentIn: tangent,
      tangentOut: tangent,
    });
    return fc.record({ target: fc.constant(target), ...ends, keys });
  });
}

/** A clip with every kind of channel and key. */
function clipOf(character: Character): fc.Arbitrary<ClipParts> {
  return fc
    .record(
      {
        file: fc.string(),
        name: fc.oneof(fc.string(), fc.constantFrom('twice', '#1', '__proto__')),
        range: fc.tuple(number, number),
        fps: fc.constantFrom(24, 25, 30, 60, 29.97),
        channels: fc.uniqueArray(channelsOf(character), {
          maxLength: 4,
          selector: ({ target }) => (target ? channelKey(target) : {}),
        }),
        unread: fc.array(fc.jsonValue(), { maxLength: 2 }),
      },
      { requiredKeys: ['file', 'name', 'range', 'fps', 'channels'] },
    )
    .map(({ range: [a, b], ...clip }) => ({ ...clip, start: Math.min(a, b), end: Math.max(a, b) }));
}

/** The clips of the character's files with new, changed, copied, renamed and missing ones. */
export function clipsOf(character: Character): fc.Arbitrary<readonly ClipParts[]> {
  const ofFile = fc.constantFrom(...character.clips);
  const renamed = fc
    .tuple(ofFile, fc.string())
    .map(([clip, name]): ClipParts => ({ ...clip, name }));
  return fc.oneof(
    fc.constant(character.clips),
    fc.array(fc.oneof(ofFile, renamed, clipOf(character)), { maxLength: 5 }),
  );
}
