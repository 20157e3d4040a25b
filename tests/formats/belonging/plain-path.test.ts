import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { plainName, plainPath, withPlainPaths } from '../../../src/formats/belonging/plain-path.ts';

describe('plainPath', () => {
  it.each([
    ['a.bmp', 'a.bmp'],
    ['tex\\a.bmp', 'tex/a.bmp'],
    ['..\\..\\tex\\a.bmp', 'tex/a.bmp'],
    ['x/../../a.bmp', 'a.bmp'],
    ['C:\\me\\a.bmp', 'me/a.bmp'],
    ['C:a.bmp', 'a.bmp'],
    ['/etc/passwd', 'etc/passwd'],
    ['//server/share/a.bmp', 'server/share/a.bmp'],
    ['http://x/y.jpg', 'x/y.jpg'],
    ['a//b/./c', 'a/b/c'],
    ['a\u0000b\u001b[2J\u202e', 'a_b_[2J_'],
    ['a\nb: "c"?', 'a_b_ _c__'],
    ['con.txt', '_con.txt'],
    ['x /a. ', 'x/a'],
    ['..', '_'],
    ['', '_'],
    ['が.bmp'.normalize('NFD'), 'が.bmp'],
  ])('makes of %j %j', (path, plain) => {
    expect(plainPath(path)).toBe(plain);
  });

  it('never leads out of its folder, whatever the text', () => {
    const piece = fc.constantFrom('..', '.', '/', '\\', 'C:', 'a', ' ', '\0', 'nul', '\u202e', '%');
    const text = fc
      .array(fc.oneof(piece, fc.string()), { maxLength: 12 })
      .map((all) => all.join(''));
    fc.assert(
      fc.property(text, (path) => {
        const segments = plainPath(path).split('/');
        expect(segments.every((each) => /^[^\p{Cc}\p{Cf}\\:]+$/u.test(each))).toBe(true);
        expect(segments.some((each) => /^\.{1,2}$/.test(each))).toBe(false);
        expect(plainPath(plainPath(path))).toBe(plainPath(path));
      }),
      { numRuns: 2000 },
    );
  });

  it('makes a name one segment', () => {
    expect(plainName('../a/b:c')).toBe('.._a_b_c');
  });
});

describe('withPlainPaths', () => {
  it('has no two paths that differ only in case', () => {
    const paths = ['../a.bmp', 'a.bmp', 'A.BMP', 'x/a', 'x\\a', 'a (2).bmp'];
    expect(withPlainPaths(paths.map((path) => ({ path }))).map(({ path }) => path)).toEqual([
      'a.bmp',
      'a (2).bmp',
      'A (3).BMP',
      'x/a',
      'x/a (2)',
      'a (2) (2).bmp',
    ]);
  });
});
