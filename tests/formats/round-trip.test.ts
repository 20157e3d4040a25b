import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import type { Format } from '../../src/formats/format.ts';
import { formats } from '../../src/formats/registry.ts';
import { expectPosable, expectSound } from '../support/check-character.ts';
import { type FileContents, readOne } from '../support/files.ts';
import { mitFiles } from '../support/mit-files.ts';
import { formatSamples } from './samples.ts';

function written(format: Format, character: Character): FileContents {
  return Object.fromEntries(format.write(character).files.map(({ path, bytes }) => [path, bytes]));
}

/** All but what the files are called. */
function content(character: Character) {
  return { ...character, name: '' };
}

async function expectRoundTrip(format: Format, character: Character): Promise<void> {
  const files = written(format, character);
  const again = await readOne(files);
  expect(content(again)).toEqual(content(character));
  expect(written(format, { ...again, name: character.name })).toEqual(files);
}

// From the registry, so that a new format cannot skip it.
describe.each(formats)('what $id writes', (format) => {
  const samples = formatSamples[format.id];

  it('has samples in tests/formats/samples.ts', () => {
    expect(samples).toBeDefined();
  });

  it.each(Object.entries(samples?.characters ?? {}))(
    'is read again as the same character: %s',
    async (_, files) => {
      const character = await readOne(files);
      expectSound(character);
      expectPosable(character);
      await expectRoundTrip(format, character);
    },
  );
});

describe('what mit writes', () => {
  const mit = formats.find(({ id }) => id === 'mit')!;

  it('is read again as the same character, for any character that it reads', async () => {
    await fc.assert(
      fc.asyncProperty(mitFiles, async (files) => {
        const character = await readOne(files);
        expectSound(character);
        await expectRoundTrip(mit, character);
      }),
      { numRuns: 300 },
    );
  });
});
