import fc from 'fast-check';
import { PNG } from 'pngjs';
import { describe, expect, it } from 'vitest';
import { insertPngText, readPngText } from '../../../src/formats/png/text-chunk.ts';
import { mutated } from '../../support/mutations.ts';

const picture = new Uint8Array(PNG.sync.write(new PNG({ width: 4, height: 3 })));
const note = '{"name":"Ä 骨","pose":{}}';
const noted = insertPngText(picture, 'Sinew', note);

/** Where the chunk of the note begins: its length, then its type. */
const chunkStart = picture.length - 12;

describe('text in a PNG', () => {
  it('is read again, whatever it says', () => {
    const texts = fc.oneof(
      fc.string({ unit: fc.constantFrom('a', 'é', '骨', '🦴', '\0', '\n', '\uFEFF', '\u202e') }),
      fc.constant('n'.repeat(20_000)),
    );
    fc.assert(
      fc.property(texts, (text) => {
        expect(readPngText(insertPngText(picture, 'Sinew', text), 'Sinew')).toBe(text);
      }),
    );
  });

  it('leaves a picture that other programs open, with valid checksums', () => {
    const { width, height, data } = PNG.sync.read(Buffer.from(noted));
    expect([width, height]).toEqual([4, 3]);
    expect(data).toEqual(PNG.sync.read(Buffer.from(picture)).data);
    expect(noted.slice(-12)).toEqual(picture.slice(-12));
  });

  it('is found only under its keyword', () => {
    expect(readPngText(noted, 'Comment')).toBeUndefined();
    expect(readPngText(noted, 'Sine')).toBeUndefined();
    expect(readPngText(picture, 'Sinew')).toBeUndefined();
    const both = insertPngText(noted, 'Comment', 'x');
    expect([readPngText(both, 'Comment'), readPngText(both, 'Sinew')]).toEqual(['x', note]);
  });

  it('is found within a larger buffer', () => {
    const buffer = new Uint8Array(noted.length + 40);
    buffer.set(noted, 17);
    expect(readPngText(buffer.subarray(17, 17 + noted.length), 'Sinew')).toBe(note);
  });

  it('is complete or absent, wherever the file is cut', () => {
    for (let end = 0; end < noted.length; end++) {
      const text = readPngText(noted.subarray(0, end), 'Sinew');
      expect(text).toBe(end < noted.length - 12 ? undefined : note);
    }
  });

  it.each([0x7fffffff, 0x80000000, 0xffffffff, 0xfffffff4, noted.length])(
    'is not looked for past a chunk that says it is %d bytes long',
    (length) => {
      for (const at of [8, chunkStart]) {
        const lying = noted.slice();
        new DataView(lying.buffer).setUint32(at, length);
        expect(readPngText(lying, 'Sinew')).toBeUndefined();
      }
    },
  );

  it('never throws, for any bytes', () => {
    const signature = noted.slice(0, 8);
    const anyBytes = fc.oneof(
      fc.uint8Array({ maxLength: 100 }),
      fc.uint8Array({ maxLength: 100 }).map((bytes) => Uint8Array.of(...signature, ...bytes)),
      mutated(noted, ['0']),
    );
    fc.assert(
      fc.property(anyBytes, (bytes) => {
        expect(['string', 'undefined']).toContain(typeof readPngText(bytes, 'Sinew'));
      }),
      { numRuns: 2000 },
    );
  });
});
