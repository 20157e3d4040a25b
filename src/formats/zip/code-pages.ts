/** The upper half of code page 437, which PKZIP had, and which most of Europe's 850 shares in its letters. */
const codePage437 =
  'ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀' +
  'αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u00a0';

/** A way to read names that are not UTF-8. */
interface CodePage {
  /** Throws where the bytes are none of its text. */
  readonly decode: (bytes: Uint8Array) => string;
  /** What its text never looks like, though the bytes of another code page may be read so. */
  readonly unlike: RegExp | undefined;
}

/**
 * In this order: models for MikuMikuDance come in Shift-JIS. Chinese and Korean read as Shift-JIS has
 * half-width punctuation, marks of sound behind letters that take none, or private letters; read as Korean,
 * Chinese has more than Korean letters.
 */
const codePages: readonly CodePage[] = [
  {
    decode: decoderOf('shift_jis'),
    unlike:
      /[\uff61-\uff64\ue000-\uf8ff]|[^\uff73\uff76-\uff84\uff8a-\uff8e]\uff9e|[^\uff8a-\uff8e]\uff9f/u,
  },
  { decode: decoderOf('euc-kr'), unlike: /[^\0-\x7f\uac00-\ud7a3]/u },
  { decode: decoderOf('gbk'), unlike: /[\ue000-\uf8ff]/u },
  { decode: decodeWestern, unlike: undefined },
];

/**
 * Names as the first code page has them that reads all of them without faults; a single high byte among the
 * small letters of a Western name is no letter of an Eastern one, whose second byte it would take.
 */
export function decodeOldNames(names: readonly Uint8Array[]): string[] {
  const binary = names.map((bytes) => String.fromCharCode(...bytes));
  if (binary.every((name) => western.test(name))) {
    return names.map(decodeWestern);
  }
  for (const { decode, unlike } of codePages) {
    try {
      const decoded = names.map(decode);
      if (!unlike || !decoded.some((name) => unlike.test(name))) return decoded;
    } catch {
      continue;
    }
  }
  return names.map(decodeWestern);
}

/** High bytes that stand alone, each between a letter and a small letter. */
const western = /^(?:[\0-\x7f]|(?<=[A-Za-z])[\x80-\x9a\xa0-\xa5\xc0-\xff](?=[a-z]))+$/;

/** As Windows has it where all high bytes are letters there, else as DOS had it. */
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
