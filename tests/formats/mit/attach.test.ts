import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readAttach } from '../../../src/formats/mit/attach.ts';
import { shown } from '../../support/diagnose.ts';
import { decimalText } from '../../support/decimals.ts';
import { bytesOf } from '../../support/files.ts';

function read(content: string) {
  const { value, diagnostics } = readAttach('a.attach', bytesOf(content));
  return { value, messages: shown(diagnostics) };
}

const effect = 'the mesh is shown without its weights';

describe('readAttach', () => {
  it('takes column i for joint i + 1 and leaves zeros out', () => {
    const { value, messages } = read('0 0.25 0.75 \n1 0 0\n-0 0 0 \n');
    expect(messages).toEqual([]);
    expect(value).toEqual({
      file: 'a.attach',
      start: Uint32Array.of(0, 2, 3, 3),
      lines: Uint32Array.of(1, 2, 3),
      joints: Uint16Array.of(2, 3, 1),
      weights: Float32Array.of(0.25, 0.75, 1),
    });
  });

  it('keeps many, negative and large weights as they are', () => {
    const row = Array.from({ length: 30 }, (_, index) => (index - 10) / 7);
    const { value } = read(row.join(' '));
    const kept = row.filter((weight) => weight !== 0);
    expect(value?.weights).toEqual(Float32Array.from(kept));
  });

  it('needs no final line end and takes blank lines after the last row', () => {
    expect(read('1 0\n0 1').value?.start).toEqual(Uint32Array.of(0, 1, 2));
    expect(read('1 0\n0 1\n\n \n# end\n').value?.start).toEqual(Uint32Array.of(0, 1, 2));
  });

  it.each([
    ['1 0\n\n0 1', ':2: expected a row of weights for every vertex, found "a blank line"', 'count'],
    ['1 0\n1\n0 1', ':2: expected 2 weights (as in the first row), found "1"', 'field-count'],
    ['1 0\n0 1 0', ':2: expected 2 weights (as in the first row), found "3"', 'field-count'],
    ['1 0\n0 nan', ':2:3: expected a number for weight 2, found "nan"', 'number'],
    ['1 0,5', ':1:3: expected a number for weight 2 with a decimal point, found "0,5"', 'number'],
    ['1e39', ':1:1: expected weight 1 within ±1e6, found "1e39"', 'range'],
    ['\n \n', ': expected a row a vertex, found "no row"', 'empty'],
  ])('refuses %j', (text, message, kind) => {
    expect(read(text)).toEqual({
      value: undefined,
      messages: [`error: a.attach${message} [attach/${kind}]; ${effect}`],
    });
  });

  it('reads plain rows as the careful reader, to which comments leave them', () => {
    const weight = fc.oneof(
      { weight: 8, arbitrary: fc.constantFrom('0', '1', '0.25', '-0', '.5', '1e-3') },
      { weight: 1, arbitrary: decimalText },
      { weight: 1, arbitrary: fc.constantFrom('nan', '2e6', '0,5', '0'.repeat(65)) },
    );
    const row = fc.oneof(
      { weight: 9, arbitrary: fc.array(weight, { minLength: 3, maxLength: 3 }) },
      { weight: 1, arbitrary: fc.array(weight, { minLength: 1, maxLength: 4 }) },
    );
    const rows = fc.array(row, { minLength: 1, maxLength: 8 });
    const lineEnds = fc.constantFrom('\n', ' \n', '\r\n');
    fc.assert(
      fc.property(rows, lineEnds, fc.boolean(), (some, lineEnd, isCut) => {
        const lines = some.map((each) => each.join(' '));
        const careful = read(lines.map((line) => `${line} #${lineEnd}`).join(''));
        const all = lines.join(lineEnd);
        expect(read(isCut ? all : all + lineEnd)).toEqual(careful);
      }),
      { numRuns: 1500 },
    );
  });

  it('lists a hundred bad weights and counts the rest', () => {
    const { messages } = read('x '.repeat(150));
    expect(messages).toHaveLength(101);
    expect(messages.at(-1)).toContain('found "50 more" [file/more]');
  });
});
