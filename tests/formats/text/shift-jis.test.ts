import { expect, it } from 'vitest';
import { shiftJisBytes } from '../../../src/formats/text/shift-jis.ts';

const decoder = new TextDecoder('shift_jis');

/** Every character that one or two bytes give. */
function allCharacters(): Set<string> {
  const found = new Set<string>();
  for (let first = 0; first < 256; first++) {
    for (let second = -1; second < 256; second++) {
      const bytes = second === -1 ? [first] : [first, second];
      const decoded = Array.from(decoder.decode(Uint8Array.from(bytes)));
      if (decoded.length === 1 && decoded[0] !== '\uFFFD') found.add(decoded[0]!);
    }
  }
  return found;
}

it('is the inverse of the decoder for every character that it gives', () => {
  const characters = allCharacters();
  expect(characters.size).toBeGreaterThan(9000);
  const wrong = [...characters].filter((character) => {
    const bytes = shiftJisBytes(character);
    return !bytes || decoder.decode(Uint8Array.from(bytes)) !== character;
  });
  expect(wrong).toEqual([]);
});

it.each([
  ['A', [0x41]],
  ['\\', [0x5c]],
  ['ﾈ', [0xc8]],
  ['あ', [0x82, 0xa0]],
  ['～', [0x81, 0x60]],
  // These have several codes: JIS comes before NEC, and IBM before the copies of its rows.
  ['∵', [0x81, 0xe6]],
  ['Ⅰ', [0x87, 0x54]],
  ['纊', [0xfa, 0x5c]],
])('writes %s as other programs do', (character, bytes) => {
  expect(shiftJisBytes(character)).toEqual(bytes);
});

it.each(['é', '한', '😀', '\uFFFD', '\uD800', 'ab', ''])('has no bytes for %j', (character) => {
  expect(shiftJisBytes(character)).toBeUndefined();
});
