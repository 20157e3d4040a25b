import { shiftJisBytes } from '../text/shift-jis.ts';

/** Stands for a character that Shift-JIS does not have. */
const substitute = '?';

/** What `decodeName` gives for a character that the end of its field cuts in two. */
const cutCharacter = '\uFFFD';
const anyLeadByte = 0x81;

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
 * Encodes as many whole characters as have room. A name that was read from a full field may end in
 * half a character; half a character is written again, so that the name stays the same.
 */
function encode(text: string, size: number): Encoded {
  const bytes: number[] = [];
  let written = '';
  for (const character of text) {
    if (character === cutCharacter && bytes.length === size - 1) {
      return { text: written + cutCharacter, bytes: [...bytes, anyLeadByte] };
    }
    // A NUL would end the text.
    const own = character === '\0' ? undefined : shiftJisBytes(character);
    const next = own ?? shiftJisBytes(substitute)!;
    if (bytes.length + next.length > size) break;
    bytes.push(...next);
    written += own ? character : substitute;
  }
  return { text: written, bytes };
}
