import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import type { FormatWriter } from '../../src/formats/format.ts';
import { writeMit } from '../../src/formats/mit/write-character.ts';
import { formats, loadWriter } from '../../src/formats/registry.ts';
import { expectPosable, expectSound } from '../support/check-character.ts';
import { type FileContents, readOne } from '../support/files.ts';
import { mitFiles } from '../support/mit-files.ts';
import { formatSamples } from './samples.ts';

function filesOf(write: FormatWriter, character: Character): FileContents {
  return Object.fromEntries(write(character).files.map(({ path, bytes }) => [path, bytes]));
}

/** Everything except the names of the files. */
function content(character: Character) {
  return { ...character, name: '' };
}

async function expectRoundTrip(write: FormatWriter, character: Character): Promise<void> {
  const files = filesOf(write, character);
  const again = await readOne(files);
  expect(content(again)).toEqual(content(character));
  expect(filesOf(write, { ...again, name: character.name })).toEqual(files);
}

const written = formats.filter(({ loadWriter }) => loadWriter !== undefined);

// Taken from the registry, so that no format can be forgotten.
describe.each(written)('what $id writes', ({ id }) => {
  const samples = formatSamples[id];

  it('has samples in tests/formats/samples.ts', () => {
    expect(samples).toBeDefined();
  });

  it.each(Object.entries(samples?.characters ?? {}))(
    'is read again as the same character: %s',
    async (_, files) => {
      const character = await readOne(files);
      expectSound(character);
      expectPosable(character);
      await expectRoundTrip(await loadWriter(id), character);
    },
  );
});

describe('what mit writes', () => {
  it('is read again as the same character, for any character that it reads', async () => {
    await fc.assert(
      fc.asyncProperty(mitFiles, async (files) => {
        const character = await readOne(files);
        expectSound(character);
        await expectRoundTrip(writeMit, character);
      }),
      { numRuns: 100 },
    );
  });
});
