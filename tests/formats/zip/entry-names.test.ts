import { describe, expect, it } from 'vitest';
import { crc32 } from '../../../src/formats/crc32.ts';
import { decodeNames, type RawName } from '../../../src/formats/zip/entry-names.ts';
import { ByteWriter } from '../../support/byte-writer.ts';
import { bytesOf } from '../../support/files.ts';

const none = new Uint8Array(0);

function raw(...bytes: number[]): RawName {
  return { bytes: Uint8Array.from(bytes), isUtf8: false, extra: none };
}

/** A Unicode Path field for a name, after a field of another kind. */
function field(name: Uint8Array, text: string, checksum = crc32(name)): Uint8Array {
  const bytes = bytesOf(text);
  const out = new ByteWriter()
    .u16(0x5455, 1)
    .u8(7)
    .u16(0x7075, 5 + bytes.length)
    .u8(1);
  return out
    .u32(checksum)
    .field(bytes.length, [...bytes])
    .done();
}

const ascii = (text: string): number[] => [...bytesOf(text)];

describe('names of archives', () => {
  it.each<[string, RawName[], string[]]>([
    ['are UTF-8 where they say so', [{ ...raw(0xe9, 0xa1, 0x94), isUtf8: true }], ['顔']],
    ['are UTF-8 where they could be', [raw(0xe9, 0xa1, 0x94), raw(...ascii('a'))], ['顔', 'a']],
    // ソ表能, whose second bytes are all 0x5C, and a backslash that separates folders.
    [
      'are Shift-JIS, decoded before backslashes part folders',
      [raw(0x83, 0x5c, 0x95, 0x5c, 0x5c, 0x94, 0x5c, ...ascii('.bmp'))],
      ['ソ表/能.bmp'],
    ],
    ['are Shift-JIS of half width', [raw(0xd0, 0xb8, 0x2e), raw(0xca, 0xde)], ['ﾐｸ.', 'ﾊﾞ']],
    [
      'are all of one code page, though some could be UTF-8',
      [raw(0xc6, 0xb1), raw(0x83, 0x5c)],
      ['ﾆｱ', 'ソ'],
    ],
    [
      'are Chinese',
      [raw(0xc4, 0xa3, 0xd0, 0xcd, 0x5c, 0xcc, 0xf9, 0xcd, 0xbc), raw(0xc1, 0xb3)],
      ['模型/贴图', '脸'],
    ],
    ['are Korean', [raw(0xb8, 0xf0, 0xb5, 0xa8), raw(0xbe, 0xf3, 0xb1, 0xbc)], ['모델', '얼굴']],
    ['are of DOS', [raw(0x4d, 0x81, ...ascii('ller.obj')), raw(0x82, 0x2e)], ['Müller.obj', 'é.']],
    ['are of DOS, between letters', [raw(...ascii('L'), 0x82, ...ascii('gs'))], ['Légs']],
    ['are of Windows', [raw(0x4d, 0xfc, ...ascii('ller.obj'))], ['Müller.obj']],
    [
      'are of Windows, with two such letters in a row',
      [raw(...ascii('cora'), 0xe7, 0xe3, ...ascii('o.bmp'))],
      ['coração.bmp'],
    ],
    // ミク\顔.bmp
    [
      'are Japanese of Unix, where they have kana',
      [raw(0xa5, 0xdf, 0xa5, 0xaf, 0x5c, 0xb4, 0xe9, ...ascii('.bmp')), raw(0xc8, 0xb1)],
      ['ミク/顔.bmp', '髪'],
    ],
    // 模型\臉.bmp and 手, whose first byte is punctuation in Shift-JIS.
    [
      'are traditional Chinese',
      [raw(0xbc, 0xd2, 0xab, 0xac, 0x5c, 0xc1, 0x79, ...ascii('.bmp')), raw(0xa4, 0xe2)],
      ['模型/臉.bmp', '手'],
    ],
    ['are of no code page', [raw(0xff, 0x80)], ['\u00a0Ç']],
  ])('%s', (_, names, decoded) => {
    expect(decodeNames(names)).toEqual(decoded);
  });

  it('are as their Unicode field has them, where it is of this name', () => {
    const { bytes } = raw(0x83, 0x5c);
    const name = (extra: Uint8Array): RawName => ({ bytes, isUtf8: false, extra });
    expect(decodeNames([name(field(bytes, 'Füße\\a'))])).toEqual(['Füße/a']);
    expect(decodeNames([name(field(bytes, 'other', 1))])).toEqual(['ソ']);
    for (let end = 0; end < field(bytes, 'abc').length; end++) {
      expect(decodeNames([name(field(bytes, 'abc').subarray(0, end))])).toEqual(['ソ']);
    }
  });

  it('that claim to be UTF-8 but are not are decoded nevertheless', () => {
    expect(decodeNames([{ ...raw(0x83, 0x5c), isUtf8: true }])).toEqual(['ソ']);
  });
});
