import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { sameValue } from '../../src/core/same-value.ts';

const number = fc.double();
const numbers = fc.array(number, { maxLength: 4 });
const value = fc.record({
  list: numbers,
  typed: numbers.map((list) => Float64Array.from(list)),
  nested: fc.record({
    text: fc.string({ maxLength: 3 }),
    flag: fc.boolean(),
    none: fc.constant(null),
  }),
});

describe('equal values', () => {
  it('are copies, whatever they contain', () => {
    fc.assert(fc.property(value, (each) => sameValue(each, structuredClone(each))));
  });

  it('are not those of which one number differs by a bit', () => {
    fc.assert(
      fc.property(value, number, (each, other) => {
        const [list, typed] = [[...each.list, 1], Float64Array.from([...each.typed, 1])];
        const changed = other === 1 ? 2 : other;
        expect(sameValue({ ...each, list }, { ...each, list: [...each.list, changed] })).toBe(
          false,
        );
        const longer = Float64Array.from([...each.typed, changed]);
        expect(sameValue({ ...each, typed }, { ...each, typed: longer })).toBe(false);
      }),
    );
  });

  it('tell zeros, lengths, missing members and kinds apart', () => {
    expect(sameValue(0, -0)).toBe(false);
    expect(sameValue(NaN, NaN)).toBe(true);
    expect(sameValue([1], [1, 2])).toBe(false);
    expect(sameValue({ a: 1 }, { b: 1 })).toBe(false);
    expect(sameValue({ a: undefined }, { b: undefined })).toBe(false);
    expect(sameValue(null, {})).toBe(false);
  });
});
