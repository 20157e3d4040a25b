import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readInteger, readNumber } from '../../../src/formats/text/read-number.ts';
import { writeFloat32, writeFloat64 } from '../../../src/formats/text/write-number.ts';
import { bytesOf } from '../../support/files.ts';
import { characterOf, decimalText } from '../../support/decimals.ts';

/** Reads the text from between other digits, because the reader must stop at its end. */
function read(text: string, reader = readNumber): number {
  const bytes = bytesOf(`9${text}9`);
  return reader(bytes, 1, bytes.length - 1);
}

describe('readNumber', () => {
  it.each(['0', '-0', '+1', '5.', '.5', '-.5e1', '1E5', '1e+05', '00012', '0.1', '123456789'])(
    'reads %s',
    (text) => {
      expect(read(text)).toBe(Number(text));
    },
  );

  it.each([
    ['as much as a double holds', '1.7976931348623157e308'],
    ['more than a double holds', '1e400'],
    ['less than a double holds', '-1e-400'],
    ['the smallest double', '5e-324'],
    ['halfway between two doubles', '9007199254740993'],
    ['halfway between two doubles, in thousandths', '9007199254740.993'],
    ['just above halfway', '9007199254740993.00000000000000000000000001'],
    ['a zero with a large exponent', '-0e9999'],
    ['the largest exact power of ten', '123456789012345e22'],
    ['one past it', '1e23'],
    ['leading zeros before long digits', '0.00000000000000000000012345678901234567'],
  ])('reads %s, correctly rounded', (_, text) => {
    expect(read(text)).toBe(Number(text));
  });

  it('equals Number, bit by bit, for decimals of every kind', () => {
    fc.assert(
      fc.property(decimalText, (text) => {
        expect(read(text)).toBe(Number(text));
      }),
      { numRuns: 3000 },
    );
  });

  it.each([
    ...['', ' ', '+', '-', '.', '+.', '-.', 'e5', '.e5', '1e', '1e+', '1e-', '1e5.', '1e5e5'],
    ...['1.2.3', '--1', '+-1', '1-', '1 ', ' 1', '1_000', '1,5', '1n', '0x10', '0b1', '0o7'],
    ...['Infinity', '-Infinity', 'inf', 'NaN', 'nan', '1.#QNAN', '1abc', '١', '1\u00a0', '1\0'],
  ])('refuses %j', (text) => {
    expect(read(text)).toBeNaN();
  });

  it('refuses text outside its grammar, even if Number accepts it', () => {
    const letters = characterOf('0123456789+-.eExX_ \tInfatyN');
    fc.assert(
      fc.property(fc.string({ unit: letters, maxLength: 8 }), (text) => {
        const isDecimal = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(text);
        expect(read(text)).toBe(isDecimal ? Number(text) : NaN);
      }),
      { numRuns: 3000 },
    );
  });

  it('accepts tokens of at most 64 characters', () => {
    expect(read('1'.padStart(64, '0'))).toBe(1);
    expect(read('1'.padStart(65, '0'))).toBeNaN();
    expect(read('1'.repeat(100_000))).toBeNaN();
  });

  it('accepts another limit', () => {
    const bytes = bytesOf('12345');
    expect([4, 5].map((longest) => readNumber(bytes, 0, 5, longest))).toEqual([NaN, 12345]);
    expect([4, 5].map((longest) => readInteger(bytes, 0, 5, longest))).toEqual([NaN, 12345]);
  });
});

describe('readInteger', () => {
  it.each(['0', '-1', '+7', '0042', '4294967297'])('reads %s', (text) => {
    expect(read(text, readInteger)).toBe(Number(text));
  });

  it.each(['', '+', '-', '1.0', '1e2', '0x1', '--1', '1a', ' 1'])('refuses %j', (text) => {
    expect(read(text, readInteger)).toBeNaN();
  });
});

describe('writing and reading again', () => {
  it('gives the same float32, bit by bit', () => {
    const numbers = fc.float({ noNaN: true, noDefaultInfinity: true });
    fc.assert(
      fc.property(numbers, (value) => {
        expect(Math.fround(read(writeFloat32(value)))).toBe(value);
      }),
      { numRuns: 3000 },
    );
  });

  it('gives the same double, bit by bit', () => {
    const numbers = fc.double({ noNaN: true, noDefaultInfinity: true });
    fc.assert(
      fc.property(numbers, (value) => {
        expect(read(writeFloat64(value))).toBe(value);
      }),
      { numRuns: 3000 },
    );
  });

  it.each([
    [0.1, '0.1'],
    [-0, '-0'],
    [16777216, '16777216'],
    [1 / 3, '0.33333334'],
    [3.4028234663852886e38, '3.4028235e+38'],
    [1.4e-45, '1e-45'],
    [-2.8e-45, '-3e-45'],
    [1e-40, '1e-40'],
    [1.17549421e-38, '1.1754942e-38'],
  ])('writes the float32 nearest to %d as %s', (value, text) => {
    expect(writeFloat32(Math.fround(value))).toBe(text);
  });
});
