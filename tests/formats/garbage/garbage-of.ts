import fc from 'fast-check';
import { expect, it } from 'vitest';
import { extensionOf } from '../../../src/formats/file-entry.ts';
import { formatExtensions } from '../../../src/formats/extensions.ts';
import type { FormatId } from '../../../src/formats/registry.ts';
import { bytesOf, type FileContents } from '../../support/files.ts';
import { mutated } from '../../support/mutations.ts';
import { expectOutcome } from '../expect-outcome.ts';
import { formatSamples } from '../samples.ts';

// `npm run test:long -- garbage --ways 2000` sets in how many ways files are changed.
const ways = Number(process.env['GARBAGE_WAYS'] ?? 120);
/** The long form cuts files at every byte, the short one at every thirteenth. */
const cutStep = 'GARBAGE_WAYS' in process.env ? 1 : 13;

/** The sample with one of its files changed. */
function withFile(contents: FileContents, name: string, bytes: Uint8Array): FileContents {
  return { ...contents, [name]: bytes };
}

/**
 * Tests a format with files that are invalid or nearly valid. Each format has a test file, so that
 * they run in parallel.
 */
export function testGarbage(id: FormatId): void {
  const { characters = {}, tokens = [], oddNumbers = [] } = formatSamples[id] ?? {};
  const extensions = formatExtensions[id];
  const samples = Object.values(characters);
  const files = samples.flatMap((contents) =>
    Object.keys(contents).map((name) => ({ contents, name, bytes: bytesOf(contents[name]!) })),
  );

  it('of any bytes', async () => {
    const extension = fc.constantFrom(...extensions);
    await fc.assert(
      fc.asyncProperty(extension, fc.uint8Array({ maxLength: 300 }), (ending, bytes) =>
        expectOutcome({ [`a${ending}`]: bytes }),
      ),
      { numRuns: ways },
    );
  });

  it('of known words in any order, alone or among good files', async () => {
    const separator = fc.constantFrom(' ', ' ', '\t', '\n', '\n', '\r\n', '\r', '\\\n', '');
    const soup = fc
      .array(fc.tuple(fc.constantFrom(...tokens, ...oddNumbers), separator), { maxLength: 60 })
      .map((parts) => bytesOf(parts.flat().join('')));
    const file = fc.constantFrom(...files);
    await fc.assert(
      fc.asyncProperty(file, soup, fc.boolean(), async ({ contents, name }, bytes, alone) => {
        await expectOutcome(withFile(alone ? {} : contents, name, bytes));
      }),
      { numRuns: ways },
    );
  });

  it('of good files cut at any byte', async () => {
    for (const { contents, name, bytes } of files) {
      for (let end = 0; end < bytes.length; end += cutStep) {
        await expectOutcome(withFile(contents, name, bytes.subarray(0, end)));
      }
    }
  });

  it.each(extensions)('of a good %s, changed in many ways', async (extension) => {
    const own = files.filter(({ name }) => extensionOf(name) === extension);
    const changed = fc
      .constantFrom(...own)
      .chain(({ contents, name, bytes }) =>
        mutated(bytes, oddNumbers).map((put) => withFile(contents, name, put)),
      );
    expect(own.length).toBeGreaterThan(0);
    await fc.assert(fc.asyncProperty(changed, expectOutcome), { numRuns: ways });
  });
}
