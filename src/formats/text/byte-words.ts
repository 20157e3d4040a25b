/** The high bit of each byte of a word of four. */
const highBits = 0x80808080 | 0;
const lowBits = 0x01010101;

/** Whether all bytes are ASCII. */
export function isAscii(bytes: Uint8Array): boolean {
  const { words, rest } = inWords(bytes);
  let bits = 0;
  for (let i = 0; i < words.length; i++) bits |= words[i]!;
  return (bits & highBits) === 0 && rest.every((byte) => byte < 0x80);
}

/** Whether any byte is 0. */
export function hasZero(bytes: Uint8Array): boolean {
  const { words, rest } = inWords(bytes);
  for (let i = 0; i < words.length; i++) {
    const word = words[i]!;
    // Of the lowest zero byte, only the difference has the high bit (Knuth, TAOCP 4A, 7.1.3).
    if (((word - lowBits) & ~word & highBits) !== 0) return true;
  }
  return rest.includes(0);
}

/** The bytes as aligned words of four, which are looked at faster, and those before and after. */
function inWords(bytes: Uint8Array): { words: Int32Array; rest: readonly number[] } {
  const start = Math.min(bytes.length, -bytes.byteOffset & 3);
  const count = (bytes.length - start) >> 2;
  return {
    words: new Int32Array(bytes.buffer, count === 0 ? 0 : bytes.byteOffset + start, count),
    rest: [...bytes.subarray(0, start), ...bytes.subarray(start + count * 4)],
  };
}
