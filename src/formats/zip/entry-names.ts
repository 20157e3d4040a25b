import { crc32 } from '../crc32.ts';
import { decodeOldNames } from './code-pages.ts';

/** The bytes of an entry's name, and what else the directory says of it. */
export interface RawName {
  readonly bytes: Uint8Array;
  /** Whether the entry's flags say that it is UTF-8. */
  readonly isUtf8: boolean;
  /** Fields beside the entry (APPNOTE 4.5). */
  readonly extra: Uint8Array;
}

/**
 * The names of an archive's files, with `/` between folders. A name is UTF-8 where it says so and is, else
 * as its Unicode field has it. The others are of one machine: UTF-8 where all of them could be, else of one
 * code page. They are decoded before `\` becomes `/`, since the second byte of a letter in Shift-JIS may be
 * a backslash.
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

/** The name of the Info-ZIP Unicode Path field, where it was made of this very name (APPNOTE 4.6.9). */
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
