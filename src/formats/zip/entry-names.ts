import { crc32 } from '../crc32.ts';
import { decodeOldNames } from './code-pages.ts';

/** The bytes of an entry's name, and other data from the directory that affects its decoding. */
export interface RawName {
  readonly bytes: Uint8Array;
  /** Whether the entry's flags declare UTF-8. */
  readonly isUtf8: boolean;
  /** The extra fields of the entry (APPNOTE 4.5). */
  readonly extra: Uint8Array;
}

/**
 * Decodes the names of an archive's files, with `/` between folders. A name that is declared and
 * valid UTF-8 is decoded as such; otherwise its Unicode field is used if there is one. The
 * remaining names come from one machine: they are UTF-8 if all of them are valid, otherwise of one
 * code page. They are decoded before `\` becomes `/`, because the second byte of a Shift-JIS
 * character may be a backslash.
 */
export function decodeNames(names: readonly RawName[]): string[] {
  const told = names.map(
    ({ bytes, isUtf8, extra }) =>
      (isUtf8 ? utf8Of(bytes) : undefined) ?? unicodeField(bytes, extra),
  );
  const untold = names.filter((_, index) => told[index] === undefined).map(({ bytes }) => bytes);
  const asUtf8 = untold.map(utf8Of).filter((name) => name !== undefined);
  const decoded = asUtf8.length === untold.length ? asUtf8 : decodeOldNames(untold);
  let next = 0;
  return told.map((name) => (name ?? decoded[next++]!).replaceAll('\\', '/'));
}

const unicodePath = 0x7075;

/**
 * The name of the Info-ZIP Unicode Path field, if it was made for this very name (APPNOTE 4.6.9).
 */
function unicodeField(name: Uint8Array, extra: Uint8Array): string | undefined {
  const view = new DataView(extra.buffer, extra.byteOffset, extra.byteLength);
  for (let at = 0; at + 4 <= extra.length;) {
    const size = view.getUint16(at + 2, true);
    const end = at + 4 + size;
    if (end > extra.length) return undefined;
    const isOurs = view.getUint16(at, true) === unicodePath && size >= 5 && extra[at + 4] === 1;
    if (isOurs && view.getUint32(at + 5, true) === crc32(name)) {
      return utf8Of(extra.subarray(at + 9, end));
    }
    at = end;
  }
  return undefined;
}

const utf8 = new TextDecoder('utf-8', { fatal: true });

function utf8Of(bytes: Uint8Array): string | undefined {
  try {
    return utf8.decode(bytes);
  } catch {
    return undefined;
  }
}
