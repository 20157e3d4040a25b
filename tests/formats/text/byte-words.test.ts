import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { hasZero, isAscii } from '../../../src/formats/text/byte-words.ts';

/** Bytes at any offset of their buffer, few of which are 0 or beyond ASCII. */
const someBytes = fc
  .tuple(
    fc.nat(7),
    fc.array(fc.oneof({ weight: 40, arbitrary: fc.integer({ min: 1, max: 127 }) }, fc.nat(255)), {
      maxLength: 40,
    }),
  )
  .map(([offset, values]) =>
    Uint8Array.from([...new Array<number>(offset).fill(0), ...values]).subarray(offset),
  );

describe('bytes in words', () => {
  it('are ASCII if each of them is', () => {
    fc.assert(
      fc.property(someBytes, (bytes) => {
        expect(isAscii(bytes)).toBe(bytes.every((byte) => byte < 0x80));
      }),
      { numRuns: 2000 },
    );
  });

  it('have a zero if one of them is', () => {
    fc.assert(
      fc.property(someBytes, (bytes) => {
        expect(hasZero(bytes)).toBe(bytes.includes(0));
      }),
      { numRuns: 2000 },
    );
  });
});
