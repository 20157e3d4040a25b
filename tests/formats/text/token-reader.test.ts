import { describe, expect, it } from 'vitest';
import { TokenReader } from '../../../src/formats/text/token-reader.ts';
import { bytesOf } from '../../support/files.ts';

/** Every token with its line and column. */
function tokens(text: string): [string, number, number][] {
  const reader = new TokenReader(bytesOf(text));
  const found: [string, number, number][] = [];
  while (reader.next()) found.push([reader.text(), reader.place.line, reader.place.column]);
  return found;
}

const texts = (text: string): string[] => tokens(text).map(([token]) => token);

describe('TokenReader', () => {
  it('separates braces from the text that they touch', () => {
    expect(texts('leg_fl{channel 14{}}{a')).toEqual([
      ...['leg_fl', '{', 'channel', '14', '{', '}', '}', '{', 'a'],
    ]);
  });

  it.each([
    ['\n', 3],
    ['\r\n', 3],
    ['\r\r\n', 3],
    ['\r', 3],
    ['\n\n', 5],
    ['\r\n\r\n', 5],
  ])('counts lines that end with %j', (end, line) => {
    expect(tokens(`a${end} b c${end}\td`).slice(-1)).toEqual([['d', line, 2]]);
  });

  it('skips every kind of white space', () => {
    expect(texts(' a\tb\vc\fd\r\n e ')).toEqual(['a', 'b', 'c', 'd', 'e']);
  });

  it('skips comments where a token could start, and counts their lines', () => {
    expect(texts('a // b {\nc # d }\r e /* f\n} */ g/*h*/ i//j k')).toEqual([
      ...['a', 'c', 'e', 'g/*h*/', 'i//j', 'k'],
    ]);
    expect(tokens('/* 1\r\n2\r\n3 */ a')).toEqual([['a', 3, 6]]);
  });

  it('remembers a comment that is never closed', () => {
    const reader = new TokenReader(bytesOf('a\n/* b\nc'));
    reader.next();
    expect(reader.openComment).toBeUndefined();
    expect(reader.next()).toBe(false);
    expect(reader.openComment).toBe(2);
    expect(reader.atEnd).toBe(true);
  });

  it('goes back to a mark, line and all', () => {
    const reader = new TokenReader(bytesOf('a\nb\nc'));
    reader.next();
    const mark = reader.mark();
    while (reader.next());
    reader.back(mark);
    expect([reader.text(), reader.line]).toEqual(['a', 1]);
    reader.next();
    expect([reader.text(), reader.line]).toEqual(['b', 2]);
  });

  it('shows the line of a token', () => {
    const reader = new TokenReader(bytesOf('a\r\n  b {c}\r\nd'));
    while (reader.text() !== 'c') reader.next();
    expect(reader.place).toEqual({ line: 2, column: 6, source: '  b {c}' });
  });

  it('is linear in white space, braces and long words', () => {
    const reader = new TokenReader(bytesOf(`${' '.repeat(10_000_000)}a${'x'.repeat(1_000_000)}`));
    expect(reader.next()).toBe(true);
    expect(reader.text()).toHaveLength(1024);
    expect(reader.number()).toBeNaN();
    expect(reader.next()).toBe(false);
  });
});
