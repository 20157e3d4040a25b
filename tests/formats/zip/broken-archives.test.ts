import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { memoryFile } from '../../../src/formats/file-entry.ts';
import { expandArchives } from '../../../src/formats/zip/expand-archives.ts';
import { said } from '../../support/diagnose.ts';
import { textOf } from '../../support/files.ts';
import { mutated } from '../../support/mutations.ts';
import { patched, zipOf } from '../../support/zip.ts';
import { expectOutcome } from '../expect-outcome.ts';

const contents = { 'a.obj': 'v 0 0 0\n'.repeat(20), 'b.skel': '0 0 0 -1\n' };
const sound = zipOf(contents);

async function messagesOf(zip: Uint8Array): Promise<string[]> {
  const { files, diagnostics } = await expandArchives([memoryFile('a.zip', zip)]);
  expect(files).toEqual([]);
  return said(diagnostics);
}

const notUnpacked = 'error: a.zip: expected files that can be unpacked, found';

describe('archives that lie', () => {
  it.each([
    ['less than it unfolds to', { size: 100 }, `${notUnpacked} ""a.obj" broken" [file/archive]`],
    ['nothing, of what unfolds', { size: 0 }, `${notUnpacked} ""a.obj" broken" [file/archive]`],
    ['more than it unfolds to', { size: 500 }, `${notUnpacked} ""a.obj" broken" [file/archive]`],
    ['another checksum', { checksum: 1 }, `${notUnpacked} ""a.obj" broken" [file/archive]`],
    [
      'terabytes in all',
      { size: 0xffffffff },
      'error: a.zip: expected an archive of usual size, ' +
        'found "more than 536870912 bytes in all" [file/limit]',
    ],
    [
      'a size past its end',
      { packedSize: 0x7fffffff },
      'error: a.zip: expected a zip archive, found ""a.obj" outside the archive" [file/archive]',
    ],
    [
      'a place past its end',
      { offset: 0x7fffffff },
      'error: a.zip: expected a zip archive, found ""a.obj" outside the archive" [file/archive]',
    ],
    [
      'another way of packing',
      { method: 14 },
      `${notUnpacked} ""a.obj" packed by method 14" [file/archive]`,
    ],
    ['a password', { flags: 1 }, `${notUnpacked} ""a.obj" under a password" [file/archive]`],
  ])('about %s are refused', async (_, fields, message) => {
    expect(await messagesOf(patched(sound, fields))).toEqual([message]);
  });
});

describe('archives that are none', () => {
  it.each([
    ['nothing', new Uint8Array(0)],
    ['text', new TextEncoder().encode('PK not a zip')],
    ['a directory without its end', sound.slice(0, -22)],
  ])('%s', async (_, bytes) => {
    expect(await messagesOf(bytes)).toEqual([
      'error: a.zip: expected a zip archive, found "no directory at its end" [file/archive]',
    ]);
  });

  it('cut at every byte', async () => {
    for (let end = 0; end < sound.length; end++) {
      expect(await messagesOf(sound.subarray(0, end))).toHaveLength(1);
    }
  });

  it('changed in 2,000 ways: files as they were, or an error', async () => {
    await fc.assert(
      fc.asyncProperty(mutated(sound, ['0', 'PK']), async (bytes) => {
        const { files, diagnostics } = await expandArchives([memoryFile('a.zip', bytes)]);
        if (files.length === 0) return; // an empty directory is one too
        expect(diagnostics.every(({ severity }) => severity === 'warning')).toBe(true);
        const texts = Object.values(contents);
        for (const file of files) expect(['', ...texts]).toContain(textOf(await file.bytes()));
      }),
      { numRuns: 2000 },
    );
  });

  it('of any bytes behind a sound one are read or refused, all the way', async () => {
    await fc.assert(
      fc.asyncProperty(fc.uint8Array({ maxLength: 200 }), (bytes) =>
        expectOutcome({ 'a.zip': Uint8Array.of(...sound, ...bytes) }),
      ),
      { numRuns: 100 },
    );
  });
});
