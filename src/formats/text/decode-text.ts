const decoder = new TextDecoder();

/** Decodes UTF-8. Invalid bytes become U+FFFD, and a byte order mark is dropped. */
export function decodeText(bytes: Uint8Array): string {
  return decoder.decode(bytes);
}

const exactDecoder = new TextDecoder('utf-8', { ignoreBOM: true });
const encoder = new TextEncoder();

/**
 * The offset of the first byte that is not valid UTF-8, or -1: decoding and encoding again changes
 * only such bytes.
 */
export function firstInvalidByte(bytes: Uint8Array): number {
  const again = encoder.encode(exactDecoder.decode(bytes));
  return bytes.findIndex((byte, i) => byte !== again[i]);
}
