import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { defaultLimits } from '../../../src/core/limits.ts';
import { PlainNumbers } from '../../../src/formats/text/plain-numbers.ts';
import { characterOf, decimalText } from '../../support/decimals.ts';
import { bytesOf } from '../../support/files.ts';

/** The numbers at the beginning of a text, and what it leaves. */
function read(text: string, { most = 100, crossesLines = false } = {}) {
  const numbers = new PlainNumbers(bytesOf(text), defaultLimits, crossesLines);
  const values = new Float64Array(most);
  const count = numbers.numbers(values, most);
  return { values: [...values.subarray(0, count)], rest: text.slice(numbers.at), numbers };
}

describe('plain numbers', () => {
  it('equal Number, bit by bit, for decimals of every kind', () => {
    const list = fc.array(decimalText, { minLength: 1, maxLength: 20 });
    fc.assert(
      fc.property(list, fc.constantFrom(' ', '\t', '  '), (texts, blank) => {
        const { values, rest } = read(`${texts.join(blank)}\n`);
        expect(values).toEqual(texts.map(Number));
        expect(rest).toBe('\n');
      }),
      { numRuns: 2000 },
    );
  });

  it('are nothing outside the grammar of numbers', () => {
    const letters = characterOf('0123456789+-.eExX_#/}InfatyN');
    fc.assert(
      fc.property(fc.string({ unit: letters, maxLength: 8 }), (text) => {
        const isDecimal = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(text);
        expect(read(`${text} \n`).values).toEqual(isDecimal ? [Number(text)] : []);
      }),
      { numRuns: 3000 },
    );
  });

  it.each([
    ['1 2 x 3\n', [1, 2], ' x 3\n'],
    ['1 2 # 3\n', [1, 2], ' # 3\n'],
    ['1 2\u00a03\n', [1], ' 2\u00a03\n'],
    ['1 2\n3\n', [1, 2], '\n3\n'],
    ['1 2\r\n3\n', [1, 2], '\r\n3\n'],
    ['1 2}\n', [1], ' 2}\n'],
    [`1 ${'0'.repeat(64)} ${'0'.repeat(65)}\n`, [1, 0], ` ${'0'.repeat(65)}\n`],
  ])('stop before anything else on a line: %j', (text, values, rest) => {
    expect(read(text)).toMatchObject({ values, rest });
  });

  it.each([
    ['1 2\n3\r\n4} 5\n', [1, 2, 3, 4], '} 5\n', 3],
    ['1\n\n 2\r3\n', [1, 2], '\r3\n', 3],
    ['1\n2\n// 3\n', [1, 2], '\n// 3\n', 2],
    ['1\n2', [1], '\n2', 1],
    ['1 2 3', [], '1 2 3', 1],
  ])('across lines, whose ends are counted: %j', (text, values, rest, line) => {
    const found = read(text, { crossesLines: true });
    expect(found).toMatchObject({ values, rest });
    expect(found.numbers.line).toBe(line);
  });

  it('are no more than were asked for', () => {
    expect(read('1 2 3\n', { most: 2 })).toMatchObject({ values: [1, 2], rest: ' 3\n' });
  });

  it('are indices if they are whole, and are counted across lines', () => {
    const numbers = new PlainNumbers(bytesOf('0 7\n 0042 999999999} \n'), defaultLimits, true);
    const values = new Int32Array(8);
    expect(numbers.indices(values, 8)).toBe(4);
    expect([...values.subarray(0, 4)]).toEqual([0, 7, 42, 999_999_999]);
    expect(numbers.line).toBe(2);
    expect(numbers.indices(values, 8)).toBe(0);
    expect(String.fromCharCode(numbers.skipBlanks())).toBe('}');
  });

  it.each(['', '-1', '+1', 'x', '1234567890', '.5', '1.', '1e1', '1x', '1#'])(
    'are no indices, as %j',
    (text) => {
      const numbers = new PlainNumbers(bytesOf(`\n${text}\n`), defaultLimits, true);
      expect(numbers.indices(new Int32Array(1), 1)).toBe(0);
      expect([numbers.at, numbers.line]).toEqual([0, 1]);
    },
  );
});
