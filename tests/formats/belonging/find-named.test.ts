import { describe, expect, it } from 'vitest';
import { findNamed } from '../../../src/formats/belonging/find-named.ts';
import { memoryFile } from '../../../src/formats/file-entry.ts';

/** The path that is found, with `?` if it is a guess and the number of other files that fit. */
function find(named: string, from: string, ...paths: string[]): string | undefined {
  const files = paths.map((path) => memoryFile(path, new Uint8Array(0)));
  const found = findNamed(named, from, files);
  if (!found) return undefined;
  const { file, isGuess, others } = found;
  return [file.path, ...(isGuess ? ['?'] : []), ...others.map(() => '+')].join(' ');
}

describe('the file that another one names', () => {
  it.each<[string, string, string, string[], string | undefined]>([
    [
      'at its path',
      'face\\t.bmp',
      'm/a.pmd',
      ['m/t.bmp', 'm/hair/t.bmp', 'm/face/t.bmp'],
      'm/face/t.bmp',
    ],
    ['at a path upward', '..\\tex\\t.bmp', 'm/a.pmd', ['m/t.bmp', 'tex/t.bmp'], 'tex/t.bmp'],
    ['at a path with dots', './x/../t.bmp', 'm/a.pmd', ['x/t.bmp', 'm/t.bmp'], 'm/t.bmp'],
    ['in the own folder', 't.bmp', 'B/b.pmd', ['A/t.bmp', 'B/t.bmp'], 'B/t.bmp'],
    [
      'in the own folder, wherever it was made',
      'C:\\me\\t.bmp',
      'B/b.pmd',
      ['A/t.bmp', 'B/t.bmp'],
      'B/t.bmp',
    ],
    [
      'in the own folder before its path elsewhere',
      'tex\\t.bmp',
      'B/b.pmd',
      ['A/tex/t.bmp', 'B/t.bmp'],
      'B/t.bmp',
    ],
    [
      'by the folders of an absolute path',
      'D:\\m\\face\\t.bmp',
      'm/a.pmd',
      ['m/hair/t.bmp', 'm/face/t.bmp'],
      'm/face/t.bmp',
    ],
    [
      'by those of another system',
      '/home/me/wasp/tex/t.bmp',
      'models/a.skin',
      ['tube/tex/t.bmp', 'wasp/tex/t.bmp'],
      'wasp/tex/t.bmp ?',
    ],
    [
      'in a folder below, before one above',
      't.bmp',
      'm/a.pmd',
      ['t.bmp', 'm/x/t.bmp'],
      'm/x/t.bmp ?',
    ],
    ['in the nearest folder', 't.bmp', 'x/m/a.pmd', ['y/t.bmp', 'x/tex/t.bmp'], 'x/tex/t.bmp ?'],
    ['anywhere', 'http://example.org/../t.bmp', 'a.skin', ['z/t.bmp'], 'z/t.bmp ?'],
    ['first by path, of two as near', 't.bmp', 'a.pmd', ['y/t.bmp', 'x/t.bmp'], 'x/t.bmp ? +'],
    ['in other letters', 'Face.PNG', 'a.pmd', ['face.png'], 'face.png'],
    ['in its own letters first', 'Face.PNG', 'a.pmd', ['FACE.png', 'Face.PNG'], 'Face.PNG'],
    ['decomposed', 'ガ顔.bmp', 'a.pmd', ['ガ顔.bmp'.normalize('NFD')], 'ガ顔.bmp'.normalize('NFD')],
    [
      'in decomposed folders',
      'ガ\\t.bmp',
      'a.pmd',
      ['x/t.bmp', `${'ガ'.normalize('NFD')}/t.bmp`],
      `${'ガ'.normalize('NFD')}/t.bmp`,
    ],
    ['with another wave dash', '〜−顔.bmp', 'a.pmd', ['～－顔.bmp'], '～－顔.bmp'],
    ['with its own wave dash first', '〜.bmp', 'a.pmd', ['～.bmp', '〜.bmp'], '〜.bmp'],
    ['with another ending', 'face.bmp', 'a.pmd', ['face.png', 'face2.png'], 'face.png ?'],
    ['that goes on', 'wasp.skin', 'a.rig', ['wasp_smooth.skin'], 'wasp_smooth.skin ?'],
    ['that goes on, of two none', 'wasp.skin', 'a.rig', ['wasp_1.skin', 'wasp_2.skin'], undefined],
    ['that only sounds alike', 'a.bmp', 'a.pmd', ['apple.bmp'], undefined],
    ['nowhere', 'a.bmp', 'a.pmd', ['b.bmp'], undefined],
    ['without a name', '..\\', 'a.pmd', ['b.bmp'], undefined],
  ])('%s', (_, named, from, paths, found) => {
    expect(find(named, from, ...paths)).toBe(found);
    expect(find(named, from, ...paths.toReversed())).toBe(found);
  });
});
