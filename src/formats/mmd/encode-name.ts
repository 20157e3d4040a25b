import { decodeName } from './decode-name.ts';
import { shiftJisBytes } from '../text/shift-jis.ts';

/** Stands for a character that Shift-JIS does not have. */
const substitute = '?';

/**
 * What `decodeName` gives for bytes that are not Shift-JIS, such as half a character at the end of a
 * field. It is written as such a byte, so that the name stays the same.
 */
const undecodable = '\uFFFD';
const undecodableByte = 0xff;

const padding = 0xfd;

/** A text as a field holds it: its bytes, and what `decodeName` gives for them. */
interface Encoded {
  readonly text: string;
  readonly bytes: readonly number[];
}

/** Returns a field of `size` bytes: the text, then, if there is room, a NUL and padding. */
export function encodeName(text: string, size: number): Uint8Array {
  const { bytes } = encode(text, size);
  const field = new Uint8Array(size).fill(padding);
  field.set(bytes);
  if (bytes.length < size) field[bytes.length] = 0;
  return field;
}

/** Returns the text that is read from a field into which this text was written. */
export function fittedText(text: string, size: number): string {
  return encode(text, size).text;
}

/**
 * Returns what is read of a text whose bytes are cut after `size` of them, even within a character,
 * as MikuMikuDance cuts names.
 */
export function cutName(text: string, size: number): string {
  return decodeName(encodeText(text).subarray(0, size));
}

/** Encodes as many whole characters as have room. */
function encode(text: string, size: number): Encoded {
  const bytes: number[] = [];
  let written = '';
  for (const character of text) {
    const own = bytesOf(character);
    const next = own ?? bytesOf(substitute)!;
    if (bytes.length + next.length > size) break;
    bytes.push(...next);
    written += own ? character : substitute;
  }
  return { text: written, bytes };
}

function bytesOf(character: string): readonly number[] | undefined {
  if (character === undecodable) return [undecodableByte];
  return character === '\0' ? undefined : shiftJisBytes(character); // a NUL would end the text
}

/** Returns a text in Shift-JIS, with a substitute for each character that it does not have. */
export function encodeText(text: string): Uint8Array {
  return Uint8Array.from(Array.from(text).flatMap((each) => bytesOf(each) ?? bytesOf(substitute)!));
}
