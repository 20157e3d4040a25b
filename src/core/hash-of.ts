/** Arrays of numbers; an element has one, two, four or eight bytes. */
type Numbers = Uint16Array | Uint32Array | Float32Array;

/**
 * Returns a text that is the same for equal arrays, and in all likelihood for no others: their
 * lengths and 64 bits over their bytes, as two sums of FNV-1a with different starts and a final mix.
 */
export function hashOf(arrays: readonly Numbers[]): string {
  let [first, second] = [0x811c9dc5, 0x9747b28c];
  for (const array of arrays) {
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    const even = bytes.length - (bytes.length % 4);
    for (let at = 0; at < even; at += 4) {
      const word =
        bytes[at]! | (bytes[at + 1]! << 8) | (bytes[at + 2]! << 16) | (bytes[at + 3]! << 24);
      first = Math.imul(first ^ word, 0x01000193);
      first ^= first >>> 15;
      second = Math.imul(second ^ word, 0x5bd1e995);
      second ^= second >>> 13;
    }
    for (let at = even; at < bytes.length; at++) {
      first = Math.imul(first ^ bytes[at]!, 0x01000193);
      second = Math.imul(second ^ bytes[at]!, 0x5bd1e995);
    }
  }
  const lengths = arrays.map(({ length }) => length).join('.');
  return `${lengths}.${(first >>> 0).toString(36)}.${(second >>> 0).toString(36)}`;
}
