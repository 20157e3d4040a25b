import { describe, expect, it } from 'vitest';
import { memoryFile } from '../../src/formats/file-entry.ts';
import { readCharacters } from '../../src/formats/read-characters.ts';
import { said, shown } from '../support/diagnose.ts';
import { bytesOf, readContents } from '../support/files.ts';
import { zipOf } from '../support/zip.ts';

const skel = '0 0 0 -1\n0 1 0 0\n';
const obj = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';

describe('readCharacters', () => {
  it('reads archives as the files in them, several characters too', async () => {
    const zip = zipOf({
      'x/a.skel': skel,
      'x/a.obj': obj,
      'b.obj': obj,
      '__MACOSX/x/._a.obj': 'junk',
    });
    const { characters, diagnostics } = await readContents({ 'all.zip': zip });
    expect(diagnostics).toEqual([]);
    expect(characters.map(({ character: { name, missing } }) => [name, missing])).toEqual([
      ['a', ['.attach']],
      ['b', ['.skel', '.attach']],
    ]);
  });

  it('reads the files next to an archive that it cannot read', async () => {
    const { characters, diagnostics } = await readContents({ 'a.obj': obj, 'b.zip': 'no zip' });
    expect(characters).toHaveLength(1);
    expect(said(diagnostics)).toEqual([
      'error: b.zip: expected a zip archive, found "no directory at its end" [file/archive]',
    ]);
  });

  it('skips junk silently and reports all unknown files in one message', async () => {
    const contents = {
      '._a.obj': 'junk',
      'x/.DS_Store': 'junk',
      'a.obj': obj,
      'readme.txt': '',
      LICENSE: '',
      'b.txt': '',
    };
    const { diagnostics } = await readContents(contents);
    expect(shown(diagnostics)).toEqual([
      'warning: readme.txt and 2 more: expected files that Sinew reads (.skel, .obj, .attach, .mtl, ' +
        '.skin, .morph, .anim, .rig, .pmd, .zip), found ".txt, no ending" [file/unknown]; they are not used',
    ]);
  });

  it('reports a file that gives fewer bytes than its size', async () => {
    const cut = { ...memoryFile('a.obj', bytesOf(obj)), size: 100 };
    const { characters, diagnostics } = await readCharacters([cut]);
    expect(characters).toHaveLength(1);
    expect(shown(diagnostics)).toEqual([
      'warning: a.obj: expected 100 bytes, found "32" [file/truncated]; ' +
        'what came of the file is read',
    ]);
  });

  it('reports what is being read, and how much came before', async () => {
    const steps: [string, number][] = [];
    const files = [memoryFile('x/a.skel', bytesOf(skel)), memoryFile('x/a.obj', bytesOf(obj))];
    await readCharacters(files, (label, fraction) => steps.push([label, fraction]));
    const before = skel.length / (skel.length + obj.length);
    expect(steps).toEqual([
      ['a.skel', 0],
      ['a.obj', before],
    ]);
  });

  it('returns nothing without files', async () => {
    expect(await readCharacters([])).toEqual({ characters: [], diagnostics: [] });
  });
});
