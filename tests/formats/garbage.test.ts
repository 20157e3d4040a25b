import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { formatDiagnostic, hasErrors } from '../../src/core/diagnostics.ts';
import { formats } from '../../src/formats/registry.ts';
import { expectPosable, expectSound } from '../support/check-character.ts';
import { bytesOf, type FileContents, readContents } from '../support/files.ts';
import { formatSamples } from './samples.ts';

/** Reads without throwing, and gives sound characters or says why not. */
async function expectOutcome(contents: FileContents): Promise<void> {
  const { characters, diagnostics } = await readContents(contents);
  for (const { character } of characters) {
    expectSound(character);
    if (character.mesh.pointCount > 0 && !hasErrors(diagnostics)) expectPosable(character);
  }
  for (const diagnostic of diagnostics) {
    const message = formatDiagnostic(diagnostic);
    expect(message).toMatch(
      /^[^\p{Cc}\p{Cf}]+: expected [^\p{Cc}\p{Cf}]+, found "[^\p{Cc}\p{Cf}]*"$/u,
    );
    expect(message.length).toBeLessThan(600);
  }
  if (characters.length === 0) expect(diagnostics.length).toBeGreaterThan(0);
}

/** The sample with one of its files changed. */
function withFile(contents: FileContents, name: string, bytes: Uint8Array): FileContents {
  return { ...contents, [name]: bytes };
}

describe.each(formats)('garbage for $id', (format) => {
  const { characters = {}, tokens = [] } = formatSamples[format.id] ?? {};
  const samples = Object.values(characters);
  const anyFile = fc
    .constantFrom(...samples)
    .chain((contents) =>
      fc.tuple(fc.constant(contents), fc.constantFrom(...Object.keys(contents))),
    );
  const extension = fc.constantFrom(...format.extensions);

  it('of any bytes', async () => {
    await fc.assert(
      fc.asyncProperty(extension, fc.uint8Array({ maxLength: 300 }), (ending, bytes) =>
        expectOutcome({ [`a${ending}`]: bytes }),
      ),
      { numRuns: 500 },
    );
  });

  it('of known words in any order, alone or among good files', async () => {
    const separator = fc.constantFrom(' ', ' ', '\t', '\n', '\n', '\r\n', '\r', '\\\n', '');
    const soup = fc
      .array(fc.tuple(fc.constantFrom(...tokens), separator), { maxLength: 60 })
      .map((parts) => bytesOf(parts.flat().join('')));
    await fc.assert(
      fc.asyncProperty(anyFile, soup, fc.boolean(), async ([contents, name], bytes, alone) => {
        await expectOutcome(withFile(alone ? {} : contents, name, bytes));
      }),
      { numRuns: 1000 },
    );
  });

  it('of good files cut at every byte', async () => {
    for (const contents of samples) {
      for (const [name, content] of Object.entries(contents)) {
        const bytes = bytesOf(content);
        for (let end = 0; end < bytes.length; end++) {
          await expectOutcome(withFile(contents, name, bytes.subarray(0, end)));
        }
      }
    }
  });

  it('of good files with bytes changed, taken out or put in', async () => {
    const edit = fc.record({
      at: fc.nat(),
      removed: fc.nat(3),
      put: fc.uint8Array({ maxLength: 3 }),
    });
    await fc.assert(
      fc.asyncProperty(anyFile, fc.array(edit, { minLength: 1, maxLength: 6 }), (file, edits) => {
        const [contents, name] = file;
        let bytes = [...bytesOf(contents[name]!)];
        for (const { at, removed, put } of edits) {
          const start = at % (bytes.length + 1);
          bytes = [...bytes.slice(0, start), ...put, ...bytes.slice(start + removed)];
        }
        return expectOutcome(withFile(contents, name, Uint8Array.from(bytes)));
      }),
      { numRuns: 1000 },
    );
  });
});
