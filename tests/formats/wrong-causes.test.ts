import { describe, expect, it } from 'vitest';
import { formatDiagnostic } from '../../src/core/diagnostics.ts';
import { shown } from '../support/diagnose.ts';
import { readContents } from '../support/files.ts';
import { squarePmd } from '../support/pmd-files.ts';
import { zipOf } from '../support/zip.ts';
import { skinText } from './cse169/bad-input/bad-input.ts';

const skel = '0 0 0 -1\n0 1 0 0\n';
const obj = 'v 0 0 0\nv 1 0 0\nv 1 2 0\nf 1 2 3\n';
const attach = '0\n0\n1\n';
const whole = { 'a.skel': skel, 'a.obj': obj, 'a.attach': attach };

async function told(files: Record<string, string | Uint8Array>): Promise<string> {
  const { diagnostics } = await readContents(files);
  return diagnostics.map(formatDiagnostic).join('\n');
}

describe('the message names the cause', () => {
  it('of a Git LFS pointer instead of a file', async () => {
    const pointer = 'version https://git-lfs.github.com/spec/v1\noid sha256:46\nsize 8\n';
    for (const name of ['a.obj', 'a.skel', 'a.skin', 'a.anim']) {
      expect(await told({ ...whole, [name]: pointer }), name).toContain(
        `${name}: expected the file itself, which "git lfs pull" brings, found "a pointer of Git LFS"`,
      );
    }
  });

  it('of a Git LFS pointer instead of a binary file', async () => {
    const pointer = 'version https://git-lfs.github.com/spec/v1\noid sha256:46\nsize 8\n';
    const pointed =
      'expected the file itself, which "git lfs pull" brings, found "a pointer of Git LFS"';
    expect(await told({ 'a.zip': pointer })).toBe(`a.zip: ${pointed}`);
    expect(await told({ 'a.pmd': pointer })).toBe(`a.pmd: ${pointed}`);
    const skin = `${skinText()}material m { texture a.png }`;
    expect(await told({ 'a.skin': skin, 'a.png': pointer })).toBe(`a.png: ${pointed}`);
    const packed = zipOf({ 'a.skin': skin, 'a.png': pointer });
    expect(await told({ 'b.zip': packed })).toBe(`a.png: ${pointed}`);
  });

  it('of rich text', async () => {
    const text = '{\\rtf1\\ansi 0 0 0 -1\\ 0 1 0 0}';
    expect(await told({ ...whole, 'a.skel': text })).toContain('found "rich text (RTF)');
    expect(await told({ ...whole, 'a.obj': text })).toContain('found "rich text (RTF)');
  });

  it.each([
    ['0 0 0\u00a0-1\n', 'a.skel:1:6: expected a plain space, found "U+00A0'],
    ['0 0 0 -1\n0\u3000 1 0 0\n', 'a.skel:2:2: expected a plain space, found "U+3000'],
    ['\u00a00 0 0 -1\n', 'a.skel:1:1: expected a plain space, found "U+00A0'],
    ['0 0 0 -1\n\t\u30000 1 0 0\n', 'a.skel:2:2: expected a plain space, found "U+3000'],
    ['0 0 0 \uff0d1\n', 'a.skel:1:7: expected a minus sign "-", found "U+FF0D'],
    ['0 0 0 \u22121\n', 'a.skel:1:7: expected a minus sign "-", found "U+2212'],
    ['0 0 0 -1\n0 1 \u20130.5 0\n', 'a.skel:2:5: expected a minus sign "-", found "U+2013'],
  ])('of a character that only looks like a blank or a minus sign: %j', async (text, message) => {
    expect(await told({ ...whole, 'a.skel': text })).toContain(message);
  });

  it.each(['\u00a0v 0 0 0', 'v\u00a00 0 0', 'f\u20031 2 3'])(
    'of a blank before or after the first word: %j',
    async (line) => {
      const message = await told({ ...whole, 'a.obj': `${line}\n${obj}` });
      expect(message).toMatch(/^a\.obj:1:\d: expected a plain space, found "U\+/);
    },
  );

  it('but accepts such characters in comments and names', async () => {
    const named = `# 1\u00a0000 faces, 3\u2212x\nusemtl a\u00a0b \u2212 c\n${obj}`;
    expect(await told({ ...whole, 'a.obj': named })).not.toContain('only looks like');
  });

  it('of a face before all vertices', async () => {
    const message = await told({ ...whole, 'a.obj': `f 1 2 3\n${obj}` });
    expect(message).toContain('a.obj:1:3: expected a vertex, but none came before');
    expect(message).toContain('vertex 1 comes later, in line 2');
    const named = await told({ ...whole, 'a.obj': `mtllib D:\\\nf 1 2 3\n${obj}` });
    expect(named).toContain('vertex 1 comes later, in line 3');
  });

  it('of images that no material names, apart from files that Sinew does not read', async () => {
    const image = new Uint8Array([0x42, 0x4d, 0, 0]);
    const message = await told({
      'a.pmd': squarePmd,
      'b.bmp': image,
      'c.png': image,
      'd.doc': 'x',
    });
    expect(message).toContain('b.bmp and 1 more: expected images that a material names');
    expect(message).toContain('d.doc: expected files that Sinew reads');
  });

  it('of images in a form that Sinew does not read', async () => {
    const message = await told({ ...whole, 'b.GIF': 'x', 'c.webp': 'x', 'd.doc': 'x' });
    expect(message).toContain(
      'b.GIF and 1 more: expected images that Sinew reads (.bmp, .png, .jpg, .jpeg, .tga), ' +
        'found ".gif, .webp"',
    );
    expect(message).toContain('d.doc: expected files that Sinew reads (.skel');
  });

  it('of a count of zero', async () => {
    const bindings = 'bindings 0 { }';
    expect(await told({ 'a.skin': skinText({ bindings }) })).toContain(
      'a.skin:3: expected no joint, for there are no bindings, found "0, vertex 0"',
    );
  });

  it('of files of two courses, in whatever folders', async () => {
    const leg = 'balljoint a {\n}\n';
    const apart = 'they are shown as two characters';
    expect(shown((await readContents({ ...whole, 'a.skel': leg })).diagnostics)).toEqual([
      'warning: a.obj: expected a .skel of MIT 6.837, ' +
        `found "a.skel of UCSD CSE169" [file/pairing]; ${apart}`,
    ]);
    expect(await told({ 'skins/a.skin': skinText(), 'skeletons/a.skel': skel })).toBe(
      'a.skin: expected a .skel of UCSD CSE169, found "a.skel of MIT 6.837"',
    );
    const others = { 'b.skel': '0 0 0 -1', 'b.obj': obj, 'c.skel': leg, 'c.skin': skinText() };
    expect(await told(others)).toBe('');
  });
});
