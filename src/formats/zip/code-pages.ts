/**
 * The upper half of code page 437, which PKZIP used. Most of Europe's code page 850 has the same
 * letters there.
 */
const codePage437 =
  'ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀' +
  'αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u00a0';

/** An encoding of names that are not UTF-8. */
interface CodePage {
  /** Throws if the bytes are not valid in this encoding. */
  readonly decode: (bytes: Uint8Array) => string;
  /**
   * Text that never occurs in this encoding's languages, but results from decoding other encodings.
   */
  readonly unlike?: RegExp;
  /** Text of which at least one name has some. */
  readonly like?: RegExp;
}

/**
 * The order matters: models for MikuMikuDance have Shift-JIS names. Chinese and Korean decoded as
 * Shift-JIS contain half-width punctuation, voicing marks after letters that take none, or
 * private-use characters, and Japanese of Unix contains a half-width point before each letter.
 * Chinese decoded as Korean contains other characters than Korean letters. The encodings of Unix
 * and of both forms of Chinese share most of their bytes, but each has its usual characters in
 * places of its own.
 */
const codePages: readonly CodePage[] = [
  {
    decode: decoderOf('shift_jis'),
    unlike:
      /[\uff61-\uff64\ue000-\uf8ff]|[^\uff73\uff76-\uff84\uff8a-\uff8e]\uff9e|[^\uff8a-\uff8e]\uff9f|\uff65.\uff65/u,
  },
  { decode: decoderOf('euc-kr'), unlike: /[^\0-\x7f\uac00-\ud7a3]/u },
  {
    decode: commonDecoderOf(
      'euc-jp',
      [
        [0xa1, 0xa1],
        [0xa3, 0xa5],
        [0xb0, 0xcf],
      ],
      0xa1,
    ),
    like: /[ぁ-ヺ]/u,
  },
  {
    decode: commonDecoderOf(
      'gbk',
      [
        [0xa1, 0xa3],
        [0xb0, 0xd7],
      ],
      0xa1,
    ),
  },
  { decode: commonDecoderOf('big5', [[0xa1, 0xc6]], 0x40) },
  { decode: decoderOf('gbk'), unlike: /[\ue000-\uf8ff]/u },
  { decode: decodeWestern },
];

/**
 * Decodes names with the first code page that decodes all of them without faults. A single high
 * byte between small letters of a Western name is not valid in an Eastern encoding, because it
 * would consume the next letter as its second byte.
 */
export function decodeOldNames(names: readonly Uint8Array[]): string[] {
  const binary = names.map((bytes) => String.fromCharCode(...bytes));
  if (binary.every((name) => western.test(name))) {
    return names.map(decodeWestern);
  }
  for (const { decode, unlike, like } of codePages) {
    try {
      const decoded = names.map(decode);
      const isUnlikely = decoded.some((name) => unlike?.test(name));
      if (!isUnlikely && (!like || decoded.some((name) => like.test(name)))) return decoded;
    } catch {
      continue;
    }
  }
  return names.map(decodeWestern);
}

/** High bytes that are isolated, each between a letter and a small letter. */
const western =
  /^(?:[\0-\x7f]|(?<=[A-Za-z])(?:[\x80-\x9a\xa0-\xa5\xc0-\xff]|[\xe0-\xff]{2})(?=[a-z]))+$/;

/**
 * Decodes with the code page of Windows if all high bytes are letters there, otherwise with that of
 * DOS.
 */
function decodeWestern(bytes: Uint8Array): string {
  const isWindows = bytes.every((byte) => byte < 0x80 || byte >= 0xc0);
  const upper = (byte: number): string =>
    isWindows ? String.fromCharCode(byte) : codePage437[byte - 0x80]!;
  return Array.from(bytes, (byte) => (byte < 0x80 ? String.fromCharCode(byte) : upper(byte))).join(
    '',
  );
}

function decoderOf(label: string): CodePage['decode'] {
  const decoder = new TextDecoder(label, { fatal: true });
  return (bytes) => decoder.decode(bytes);
}

/**
 * A decoder of the usual characters only.
 *
 * @param firsts ranges of their first bytes
 * @param lowestSecond their lowest second byte
 */
function commonDecoderOf(
  label: string,
  firsts: readonly (readonly [lowest: number, highest: number])[],
  lowestSecond: number,
): CodePage['decode'] {
  const decode = decoderOf(label);
  return (bytes) => {
    for (let at = 0; at < bytes.length; at++) {
      const first = bytes[at]!;
      if (first < 0x80) continue;
      const isCommon = firsts.some(([lowest, highest]) => first >= lowest && first <= highest);
      if (!isCommon || bytes[++at]! < lowestSecond) throw new RangeError('a rare character');
    }
    return decode(bytes);
  };
}
