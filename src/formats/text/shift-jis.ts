const replacementCharacter = '\uFFFD';

/** Bytes that start a character of two bytes, and those that can end it. */
const leads = [...range(0x81, 0x9f), ...range(0xe0, 0xfc)];
const trails = [...range(0x40, 0x7e), ...range(0x80, 0xfc)];

/**
 * Two rows repeat characters that IBM's rows 0xFA to 0xFC have too. Programs write the latter, as
 * the WHATWG encoding standard does.
 */
const repeatedLeads = [0xed, 0xee];

/** The bytes of each character that Shift-JIS has, made at first use. */
let table: ReadonlyMap<string, readonly number[]> | undefined;

/**
 * Returns the Shift-JIS bytes of one character, so that `TextDecoder` gives that character again;
 * nothing if Shift-JIS does not have it.
 */
export function shiftJisBytes(character: string): readonly number[] | undefined {
  table ??= invertDecoder();
  return table.get(character);
}

/** Of several byte sequences for a character, the first is used. */
function invertDecoder(): Map<string, readonly number[]> {
  const decoder = new TextDecoder('shift_jis');
  const bytesOf = new Map<string, readonly number[]>();
  const add = (bytes: readonly number[]): void => {
    const decoded = Array.from(decoder.decode(Uint8Array.from(bytes)));
    const [character] = decoded;
    if (decoded.length !== 1 || character === replacementCharacter) return;
    if (!bytesOf.has(character!)) bytesOf.set(character!, bytes);
  };
  for (const byte of range(0x00, 0xff)) add([byte]);
  for (const lead of [...leads.filter((each) => !repeatedLeads.includes(each)), ...repeatedLeads]) {
    for (const trail of trails) add([lead, trail]);
  }
  return bytesOf;
}

function range(first: number, last: number): number[] {
  return Array.from({ length: last - first + 1 }, (_, index) => first + index);
}
