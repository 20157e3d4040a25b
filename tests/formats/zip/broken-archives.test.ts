import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { memoryFile } from '../../../src/formats/file-entry.ts';
import { printable } from '../../../src/core/diagnostics.ts';
import { defaultArchiveLimits, expandArchives } from '../../../src/formats/zip/expand-archives.ts';
import { shown } from '../../support/diagnose.ts';
import { textOf } from '../../support/files.ts';
import { mutated } from '../../support/mutations.ts';
import { describedZip, patched, zipOf } from '../../support/zip.ts';
import { expectOutcome } from '../expect-outcome.ts';

const contents = { 'a.obj': 'v 0 0 0\n'.repeat(20), 'b.skel': '0 0 0 -1\n' };
const sound = zipOf(contents);

async function read(zip: Uint8Array) {
  const { files, diagnostics } = await expandArchives([memoryFile('a.zip', zip)]);
  return { paths: files.map(({ path }) => path), messages: shown(diagnostics), files };
}

describe('one bad file of an archive is left out and reported, and the others are read', () => {
  it.each([
    ['less than it unfolds to', { size: 100 }, 'broken'],
    ['nothing, of what unfolds', { size: 0 }, 'broken'],
    ['more than it unfolds to', { size: 500 }, 'broken'],
    ['another checksum', { checksum: 1 }, 'broken'],
    ['terabytes', { size: 0xffffffff }, 'past 536870912 bytes in all'],
    ['a size past its end', { packedSize: 0x7fffffff }, 'not all in the archive'],
    ['a place past its end', { offset: 0x7fffffff }, 'not all in the archive'],
    ['another way of packing', { method: 14 }, 'packed by method 14'],
    ['a password', { flags: 1 }, 'under a password'],
  ])('that says %s', async (_, fields, reason) => {
    const { paths, messages } = await read(patched(sound, fields));
    expect(paths).toEqual(['a.zip/b.skel']);
    const found = printable(`1 ${reason}: a.obj`);
    expect(messages).toEqual([
      `error: a.zip: expected files that can be unpacked, found "${found}" [file/archive]; ` +
        'left out: "a.obj"; the rest is read',
    ]);
  });

  it('is not an error if it is an image', async () => {
    const { paths, messages } = await read(
      patched(zipOf({ 'x/a.bmp': 'image', ...contents }), { checksum: 1 }),
    );
    expect(paths).toEqual(['a.zip/a.obj', 'a.zip/b.skel']);
    expect(messages[0]).toMatch(/^warning: .* "1 broken: a\.bmp"/);
  });

  it.each([
    ['with the mark of a folder on DOS', { attributes: 0x10 }, { 'tex.d': '' }],
    ['with the mark of a folder on Unix', { attributes: 0x41ed0000 }, { 'tex.pmd': '' }],
    ['that other files are in', {}, { 'tex.pmd': '', 'tex.pmd/c.skel': '0 0 0 -1\n' }],
  ])('is not a folder without a slash, %s', async (_, fields, folder) => {
    const zip = patched(zipOf({ ...folder, ...contents }), { method: 12, ...fields });
    const { paths, messages } = await read(zip);
    expect(paths.toSorted().slice(0, 2)).toEqual(['a.zip/a.obj', 'a.zip/b.skel']);
    expect(paths).toHaveLength(Object.keys(folder).length + 1);
    expect(messages).toEqual([]);
  });

  it('is reported once for each reason, however many there are', async () => {
    const many = Object.fromEntries(Array.from({ length: 9 }, (_, i) => [`${i}.obj`, 'v']));
    const limits = { ...defaultArchiveLimits, totalSize: 2 };
    const { files, diagnostics } = await expandArchives([memoryFile('a.zip', zipOf(many))], limits);
    expect(files).toHaveLength(2);
    expect(shown(diagnostics)).toEqual([
      'error: a.zip: expected files that can be unpacked, found "7 past 2 bytes in all: 2.obj" ' +
        '[file/archive]; left out: "2.obj", "3.obj", "4.obj", "5.obj" and 3 more; the rest is read',
    ]);
  });

  it('may be a name that occurs twice; the last one counts', async () => {
    const zip = zipOf({ 'a.obj': 'first', 'b.obj': 'other' });
    const twice = zip.map((byte, i) => (byte === 0x62 && zip[i + 1] === 0x2e ? 0x61 : byte));
    const { files, messages } = await read(twice);
    expect(files).toHaveLength(1);
    expect(textOf(await files[0]!.bytes())).toBe('other');
    expect(messages).toEqual([
      'warning: a.zip: expected each name once, found "1 again, as "a.obj"" [file/duplicate]; ' +
        'the last of each counts',
    ]);
  });
});

describe('files that are not archives', () => {
  it.each([
    ['nothing', new Uint8Array(0)],
    ['text', new TextEncoder().encode('PK not a zip')],
  ])('%s', async (_, bytes) => {
    expect(await read(bytes)).toMatchObject({
      paths: [],
      messages: [
        'error: a.zip: expected a zip archive, found "no directory at its end" [file/archive]; ' +
          'the archive is not used',
      ],
    });
  });
});

describe('archives without a directory', () => {
  const lost =
    'error: a.zip: expected a whole zip archive, found "no directory at its end" [file/archive]';

  it('give their files by the header before each', async () => {
    const { paths, messages } = await read(sound.slice(0, -22));
    expect(paths).toEqual(['a.zip/a.obj', 'a.zip/b.skel']);
    expect(messages).toEqual([`${lost}; what is left of it is read: 2 files`]);
  });

  it.each([true, false])('or by the sizes after each, with a signature: %s', async (isSigned) => {
    const { paths } = await read(describedZip(contents, isSigned));
    expect(paths).toEqual(['a.zip/a.obj', 'a.zip/b.skel']);
  });

  it('report the file in which they were cut', async () => {
    const second = sound.findIndex((byte, i) => i > 0 && byte === 0x50 && sound[i + 2] === 3);
    const { paths, messages } = await read(sound.slice(0, second + 38));
    expect(paths).toEqual(['a.zip/a.obj']);
    expect(messages[0]).toContain(lost);
    expect(messages[1]).toContain('1 not all in the archive: b.skel');
  });

  it('that are cut at any byte are reported, and give only complete files', async () => {
    for (let end = 0; end < sound.length; end++) {
      const { files, messages } = await read(sound.subarray(0, end));
      expect(messages.length).toBeGreaterThan(0);
      for (const file of files) {
        expect(Object.values(contents)).toContain(textOf(await file.bytes()));
      }
    }
  });

  it('may follow a self-extracting program', async () => {
    const program = new TextEncoder().encode('MZ and more');
    const { paths, messages } = await read(Uint8Array.of(...program, ...sound));
    expect([paths, messages]).toEqual([['a.zip/a.obj', 'a.zip/b.skel'], []]);
  });

  it('that are changed in 500 ways give unchanged files or a message', async () => {
    await fc.assert(
      fc.asyncProperty(mutated(sound, ['0', 'PK']), async (bytes) => {
        const { files } = await read(bytes);
        const texts = Object.values(contents);
        for (const file of files) expect(['', ...texts]).toContain(textOf(await file.bytes()));
      }),
      { numRuns: 500 },
    );
  });

  it('of random bytes after a valid part are read or refused without an exception', async () => {
    await fc.assert(
      fc.asyncProperty(fc.uint8Array({ maxLength: 200 }), (bytes) =>
        expectOutcome({ 'a.zip': Uint8Array.of(...sound, ...bytes) }),
      ),
      { numRuns: 100 },
    );
  });
});
