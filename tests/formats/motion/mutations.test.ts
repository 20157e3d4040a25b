import fc from 'fast-check';
import { expect, it } from 'vitest';
import { clipFor, evaluateClip } from '../../../src/core/motion/clip.ts';
import { readBoundMotion } from '../../../src/formats/motion/read-bound-motion.ts';
import { writeMotion } from '../../../src/formats/motion/write-motion.ts';
import { bytesOf } from '../../support/files.ts';
import { mover } from './mover.ts';

const motion = {
  version: 1,
  fps: 30,
  range: [0, 2],
  channels: [
    {
      target: { joint: 'elbow', value: 'rx' },
      extrapolate: ['cycle', 'linear'],
      keys: [
        [0, 0, 'flat', 1],
        [1, 1, ['tcb', 1, 0, -1], 'stepped'],
        [2, 0],
      ],
    },
    {
      target: { joint: 'neck', rotation: 'squad' },
      keys: [
        [0, [0, 0, 0, 1]],
        [1, [1, 0, 0, 0]],
        [2, [0, 0, 0, -1]],
      ],
    },
    { target: { morph: 'smile' }, keys: [[0, 1]] },
    { target: { pin: 'wrist', value: 'x' }, keys: [[0, 1]] },
    { target: { light: 1 }, keys: 3 },
  ],
};

/** What stands in the place of a value, or nothing, which removes it. */
const others = fc.constantFrom<unknown>(
  ...[undefined, null, true, 0, -1, 1e300, -1e18, 1e18, 1e-320, '', 'neck', '#0', '#99', 'auto'],
  ...['rx', 'squad', 'bounce', '__proto__', [], {}, [[]], [0, 0], [0, 0, 0, 0], { joint: 'elbow' }],
);

interface Change {
  /** Which member is entered at each depth, as a part of how many there are. */
  readonly way: readonly number[];
  readonly value: unknown;
}

const changes: fc.Arbitrary<Change> = fc.record({
  way: fc.array(fc.double({ min: 0, max: 1, maxExcluded: true, noNaN: true }), {
    minLength: 1,
    maxLength: 6,
  }),
  value: others,
});

/** The value with another one somewhere in it. */
function changed(value: unknown, { way: [part, ...way], value: other }: Change): unknown {
  if (part === undefined || typeof value !== 'object' || value === null) return other;
  const entries = Object.entries(value);
  const at = Math.floor(part * entries.length);
  const made = entries.flatMap(([key, member], index): [string, unknown][] => {
    if (index !== at) return [[key, member]];
    const inner = changed(member, { way, value: other });
    return inner === undefined ? [] : [[key, inner]];
  });
  return Array.isArray(value) ? made.map(([, member]) => member) : Object.fromEntries(made);
}

it('reads any motion with something else in it as finite values or with a message, and writes it again', () => {
  fc.assert(
    fc.property(fc.array(changes, { minLength: 1, maxLength: 3 }), (all) => {
      const json = all.reduce<unknown>((value, change) => changed(value, change), motion);
      const text = JSON.stringify(json);
      const { value, diagnostics } = readBoundMotion('a.json', bytesOf(text), mover);
      expect(diagnostics.every(({ line }) => line === 1)).toBe(true);
      if (!value) {
        expect(diagnostics).not.toEqual([]);
        return;
      }
      const q = mover.skeleton.qRest.slice();
      const values = { q, morphWeights: new Float64Array(4), pins: new Float64Array(16) };
      for (const time of [-1e9, -1, 0.3, 1.7, 5, 1e9]) {
        evaluateClip(clipFor(value, mover), time, values);
        const found = [...values.q, ...values.morphWeights, ...values.pins];
        expect(found.every(Number.isFinite), String(time)).toBe(true);
      }
      const [written] = writeMotion(value, mover).files;
      expect(readBoundMotion('a.json', written!.bytes, mover).value).toStrictEqual(value);
    }),
    { numRuns: 500 },
  );
});
