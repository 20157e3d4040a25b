import { zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { memoryFile } from '../../../src/formats/file-entry.ts';
import { defaultArchiveLimits, expandArchives } from '../../../src/formats/zip/expand-archives.ts';
import { said } from '../../support/diagnose.ts';
import { bytesOf, type FileContents, textOf } from '../../support/files.ts';
import { zipOf } from '../../support/zip.ts';

/** The resulting paths and texts, and the messages. */
async function expand(zip: Uint8Array, limits = defaultArchiveLimits) {
  const { files, diagnostics } = await expandArchives([memoryFile('a.zip', zip)], limits);
  const entries = files.map(
    async (file) => [file.path.replace(/^a.zip\//, ''), textOf(await file.bytes())] as const,
  );
  return { files: await Promise.all(entries), messages: said(diagnostics) };
}

async function messagesOf(contents: FileContents, limits: Partial<typeof defaultArchiveLimits>) {
  return (await expand(zipOf(contents), { ...defaultArchiveLimits, ...limits })).messages;
}

describe('expandArchives', () => {
  it('puts the files of an archive in a folder of its name, compressed and stored ones', async () => {
    const text = 'v 0 0 0\n'.repeat(50);
    const packed = await expand(zipOf({ 'x/a.obj': text, 'b.skel': '0 0 0 -1' }));
    expect(packed).toEqual({
      files: [
        ['x/a.obj', text],
        ['b.skel', '0 0 0 -1'],
      ],
      messages: [],
    });
    expect(await expand(zipSync({ 'x/a.obj': bytesOf(text) }, { level: 0 }))).toMatchObject({
      files: [['x/a.obj', text]],
    });
    const plain = memoryFile('c.obj', bytesOf('v'));
    const { files } = await expandArchives([plain, memoryFile('A.ZIP', zipOf({ 'a.obj': 'v' }))]);
    expect(files.map(({ path }) => path)).toEqual(['c.obj', 'A.ZIP/a.obj']);
  });

  it.each([
    ['backslashes', 'x\\y\\a.obj', 'x/y/a.obj'],
    ['marks and other scripts', 'Müller 骨/模型.obj', 'Müller 骨/模型.obj'],
    ['the name of a prototype', '__proto__/__proto__.obj', '__proto__/__proto__.obj'],
    ['ways up', '../../a.obj', '../../a.obj'],
    ['capitals', 'A.OBJ', 'A.OBJ'],
  ])('takes names with %s', async (_, name, path) => {
    const { files } = await expand(zipOf({ [name]: 'v' }));
    expect(files).toEqual([[path, 'v']]);
  });

  it('skips files that operating systems add, and folders', async () => {
    const zip = zipOf({
      'x/': '',
      'x/a.obj': 'v',
      '__MACOSX/x/._a.obj': 'junk',
      'x/._a.obj': 'junk',
      'x/.DS_Store': 'junk',
    });
    expect(await expand(zip)).toEqual({ files: [['x/a.obj', 'v']], messages: [] });
  });

  it('lists files that no format reads, without their bytes', async () => {
    const { files } = await expand(zipOf({ 'readme.txt': 'hello', 'a.obj': 'v' }));
    expect(files).toEqual([
      ['readme.txt', ''],
      ['a.obj', 'v'],
    ]);
  });

  it('does not open archives within archives', async () => {
    const zip = zipOf({ 'inner.zip': zipOf({ 'b.obj': 'v' }), 'a.obj': 'v' });
    expect(await expand(zip)).toEqual({
      files: [['a.obj', 'v']],
      messages: ['warning: a.zip: expected files in the archive, found "inner.zip" [file/archive]'],
    });
  });
});

describe('the limits of archives', () => {
  it('count all files', async () => {
    const contents = { 'a.obj': 'v', 'b.txt': '', '__MACOSX/c': '' };
    expect(await messagesOf(contents, { entryCount: 3 })).toEqual([]);
    const found = '"more than 2 files" [file/limit]';
    const usual = 'error: a.zip: expected an archive of usual size, found';
    expect(await messagesOf(contents, { entryCount: 2 })).toEqual([`${usual} ${found}`]);
  });

  it('apply to the total bytes that are read', async () => {
    const contents = { 'a.obj': 'v'.repeat(60), 'b.obj': 'v'.repeat(40), 'c.txt': 'x'.repeat(999) };
    expect(await messagesOf(contents, { totalSize: 100 })).toEqual([]);
    expect(await messagesOf(contents, { totalSize: 99 })).toEqual([
      'error: a.zip: expected files that can be unpacked, ' +
        'found "1 past 99 bytes in all: b.obj" [file/archive]',
    ]);
  });

  it('apply to the ratio of a file if it is large', async () => {
    const contents = { 'a.obj': 'v'.repeat(1_000_000) };
    expect(await messagesOf(contents, { freeSize: 1_000_000 })).toEqual([]);
    expect(await messagesOf(contents, { freeSize: 0, ratio: 2000 })).toEqual([]);
    const [message] = await messagesOf(contents, { freeSize: 999_999 });
    expect(message).toMatch(/found "1 too large, 1000000 bytes from \d+: a/);
  });

  it('allow the weights of a rigid model, which compress four hundred to one', async () => {
    const weights = `${'0 '.repeat(56)}1\n`.repeat(10_000);
    const zip = zipOf({ 'a.attach': weights });
    expect(weights.length / zip.length).toBeGreaterThan(200);
    expect((await expand(zip)).messages).toEqual([]);
  });
});
