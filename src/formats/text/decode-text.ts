const decoder = new TextDecoder();

/** Bytes that are no UTF-8 become U+FFFD; a byte order mark is dropped. */
export function decodeText(bytes: Uint8Array): string {
  return decoder.decode(bytes);
}

const exactDecoder = new TextDecoder('utf-8', { ignoreBOM: true });
const encoder = new TextEncoder();

/** Where the bytes are no UTF-8, or -1: what is decoded and encoded again is the same but for those. */
export function firstInvalidByte(bytes: Uint8Array): number {
  const again = encoder.encode(exactDecoder.decode(bytes));
  return bytes.findIndex((byte, i) => byte !== again[i]);
}
