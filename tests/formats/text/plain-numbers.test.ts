import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { defaultLimits } from '../../../src/core/limits.ts';
import { notWhole, PlainNumbers } from '../../../src/formats/text/plain-numbers.ts';
import { characterOf, decimalText } from '../../support/decimals.ts';
import { bytesOf } from '../../support/files.ts';

/** The numbers at the beginning of a text, and what it leaves. */
function read(text: string, { most = 100, crossesLines = false } = {}) {
  const numbers = new PlainNumbers(bytesOf(text), defaultLimits, crossesLines);
  const values = new Float64Array(most);
  const count = numbers.numbers(values, most);
  return { values: [...values.subarray(0, count)], rest: text.slice(numbers.at), numbers };
}

function integer(text: string): number {
  return new PlainNumbers(bytesOf(`${text}\n`), defaultLimits, false).integer();
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

  it.each(['0', '7', '-1', '0042', '999999999', '-999999999'])('are whole, as %s', (text) => {
    expect(integer(text)).toBe(Number(text) + 0);
  });

  it.each(['', '-', '+1', 'x', '1234567890', '.5'])('are not whole, as %j', (text) => {
    expect(integer(text)).toBe(notWhole);
  });
});
