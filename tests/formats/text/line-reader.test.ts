import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { DiagnosticLog } from '../../../src/core/diagnostics.ts';
import { defaultLimits } from '../../../src/core/limits.ts';
import { LineReader } from '../../../src/formats/text/line-reader.ts';
import { characterOf } from '../../support/decimals.ts';
import { bytesOf } from '../../support/files.ts';

/** [line, column, text] of every token. */
const log = new DiagnosticLog('a.obj');

function tokensOf(text: string, ...continued: string[]): [number, number, string][] {
  const reader = new LineReader(bytesOf(text), log, { continued: new Set(continued) });
  const tokens: [number, number, string][] = [];
  while (reader.next()) {
    while (reader.token()) {
      tokens.push([reader.place.line, reader.place.column, reader.text()]);
    }
  }
  return tokens;
}

const lineEnds = [
  ['LF', '\n'],
  ['CRLF', '\r\n'],
  ['CR CR LF', '\r\r\n'],
  ['bare CR', '\r'],
] as const;

describe('LineReader', () => {
  it.each(lineEnds)('counts lines and columns over %s', (_, end) => {
    const text = ['a b', '', '  c\td # x y', '#all', 'e', 'f'].join(end);
    const expected = [
      [1, 1, 'a'],
      [1, 3, 'b'],
      [3, 3, 'c'],
      [3, 5, 'd'],
      [5, 1, 'e'],
      [6, 1, 'f'],
    ];
    expect(tokensOf(text)).toEqual(expected);
    expect(tokensOf(text + end)).toEqual(expected);
  });

  it('reads the same lines whatever ends them', () => {
    const line = fc.string({ unit: characterOf('ab # \t.'), maxLength: 6 });
    const ends = fc.constantFrom(...lineEnds.map(([, end]) => end));
    fc.assert(
      fc.property(fc.array(line), ends, (lines, end) => {
        expect(tokensOf(lines.join(end))).toEqual(tokensOf(lines.join('\n')));
      }),
    );
  });

  it('reads a comment mark within a token as part of it', () => {
    expect(tokensOf('a#b \\ c\\d')).toEqual([
      [1, 1, 'a#b'],
      [1, 5, '\\'],
      [1, 7, 'c\\d'],
    ]);
  });

  it.each(lineEnds)('joins continued lines over %s, under the number of the first', (_, end) => {
    const text = ['a \\', 'b\\', '  c', 'd', ''].join(end);
    const tokens = tokensOf(text, 'a').map(([line, , token]) => [line, token]);
    expect(tokens).toEqual([
      [1, 'a'],
      [1, 'b'],
      [1, 'c'],
      [4, 'd'],
    ]);
  });

  it('joins no line to one whose comment or name ends in a backslash', () => {
    const text = '  # in C:\\\na b # c\\\na \\\n c #\\\nd C:\\\na';
    const tokens = tokensOf(text, 'a').map(([line, , token]) => [line, token]);
    expect(tokens).toEqual([
      ...[
        [2, 'a'],
        [2, 'b'],
        [3, 'a'],
        [3, 'c'],
        [5, 'd'],
        [5, 'C:\\'],
        [6, 'a'],
      ],
    ]);
  });

  it('copes with a continuation that nothing follows', () => {
    expect(tokensOf('a b\\', 'a').map(([, , token]) => token)).toEqual(['a', 'b']);
    expect(tokensOf('a \\\n', 'a').map(([, , token]) => token)).toEqual(['a']);
  });

  it('counts the tokens of a line and goes back to before the first', () => {
    const reader = new LineReader(bytesOf(' a b c # d\nx'), log);
    reader.next();
    expect(reader.countTokens()).toBe(3);
    reader.token();
    expect([reader.text(), reader.rest()]).toEqual(['a', 'b c # d']);
  });

  it('shows words shortened', () => {
    const reader = new LineReader(bytesOf(`x${'y'.repeat(1000)} z`), log);
    reader.next();
    reader.token();
    expect(reader.text()).toHaveLength(256);
    expect(reader.rest()).toBe('z');
  });

  it('reports the first line that is not UTF-8, once', () => {
    const own = new DiagnosticLog('a.obj');
    const bytes = [...bytesOf('a Ä\nb '), 0xc4, 0x0a, 0xff];
    const reader = new LineReader(Uint8Array.from(bytes), own);
    while (reader.next());
    expect(own.diagnostics).toMatchObject([
      { severity: 'warning', code: 'file/encoding', line: 2, column: 3, found: 'byte 0xC4' },
    ]);
  });

  it.each([false, true])('ends at a line past the limit, joined or not: %j', (joins) => {
    const own = new DiagnosticLog('a.obj');
    const limits = { ...defaultLimits, lineLength: 10 };
    const text = `${'x'.repeat(10)}\n${joins ? 'a cdef\\\nghij' : 'abcdefghijk'}\nz\n`;
    const reader = new LineReader(bytesOf(text), own, { continued: new Set('a'), limits });
    expect([reader.next(), reader.next(), reader.next()]).toEqual([true, false, false]);
    expect(own.diagnostics).toMatchObject([
      { severity: 'error', code: 'file/limit', line: 2, expected: 'a line of at most 10 bytes' },
    ]);
  });

  it('shows the line itself, shortened', () => {
    const reader = new LineReader(bytesOf(`first\r\nsecond ${'x'.repeat(500)}\r\n`), log);
    reader.next();
    expect(reader.linePlace).toEqual({ line: 1, source: 'first' });
    reader.next();
    expect(reader.linePlace.source).toHaveLength(160);
  });

  // Searching for the line feed from each of them would take minutes.
  it('takes time proportional to the file, even if it has only carriage returns', () => {
    const reader = new LineReader(new Uint8Array(300_000).fill(0x0d), log);
    let count = 0;
    while (reader.next()) count++;
    expect(count).toBe(300_000);
  });
});
