import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { decodeName } from '../../../src/formats/mmd/decode-name.ts';
import { encodeName, fittedText } from '../../../src/formats/mmd/encode-name.ts';
import { fittedNames } from '../../../src/formats/mmd/fitted-names.ts';

const text = fc.oneof(
  fc.string({ unit: 'grapheme', maxLength: 30 }),
  fc.string({
    unit: fc.constantFrom('a', '骨', 'ﾈ', '\0', '\uFFFD', 'é', '😀', '\\'),
    maxLength: 30,
  }),
);

describe('encodeName', () => {
  it('fills a field with the text, a NUL and padding', () => {
    expect([...encodeName('骨a', 6)]).toEqual([0x8d, 0x9c, 0x61, 0, 0xfd, 0xfd]);
    expect([...encodeName('骨骨', 4)]).toEqual([0x8d, 0x9c, 0x8d, 0x9c]);
  });

  it('cuts between characters, and replaces what Shift-JIS does not have', () => {
    expect([...encodeName('骨骨', 3)]).toEqual([0x8d, 0x9c, 0]);
    expect(fittedText('é😀\0b', 20)).toBe('???b');
  });

  it('gives a field from which the fitted text is read, for any text', () => {
    fc.assert(
      fc.property(text, fc.integer({ min: 1, max: 24 }), (name, size) => {
        const field = encodeName(name, size);
        expect(field).toHaveLength(size);
        expect(decodeName(field)).toBe(fittedText(name, size));
        expect(fittedText(fittedText(name, size), size)).toBe(fittedText(name, size));
      }),
      { numRuns: 500 },
    );
  });

  it('keeps a name that was read from any field', () => {
    fc.assert(
      fc.property(fc.uint8Array({ minLength: 20, maxLength: 20 }), (field) => {
        const name = decodeName(field);
        expect(decodeName(encodeName(name, 20))).toBe(name);
      }),
      { numRuns: 500 },
    );
    const cut = decodeName(Uint8Array.of(0x8d, 0x9c, 0x8d));
    expect(cut).toBe('骨\uFFFD');
    expect(decodeName(encodeName(cut, 3))).toBe(cut);
  });
});

describe('fittedNames', () => {
  it('cuts names, and numbers those that became equal', () => {
    const long = 'a long name of a joint';
    const names = [`${long} A`, `${long} B`, 'short', `${long} A`, long.slice(0, 20)];
    expect(fittedNames(names, 20)).toEqual([
      'a long name of a (2)',
      'a long name of a (3)',
      'short',
      'a long name of a (2)',
      'a long name of a joi',
    ]);
    expect(fittedNames(['骨é', '骨à', '骨骨骨骨骨骨骨骨骨骨骨'], 20)).toEqual([
      '骨?',
      '骨? (2)',
      '骨骨骨骨骨骨骨骨骨骨',
    ]);
  });

  it('fit, are equal only where the names were, and change only if a name must', () => {
    const similar = fc.string({ unit: fc.constantFrom('骨', 'é', 'à', '?', ' (2)'), maxLength: 7 });
    fc.assert(
      fc.property(fc.array(similar, { maxLength: 12 }), (names) => {
        const written = fittedNames(names, 8);
        expect(written.map((name) => fittedText(name, 8))).toEqual(written);
        names.forEach((name, i) => {
          if (fittedText(name, 8) === name) expect(written[i]).toBe(name);
          names.forEach((other, j) => {
            expect(written[i] === written[j]).toBe(name === other);
          });
        });
      }),
      { numRuns: 500 },
    );
  });
});
