import { crc32 } from '../crc32.ts';

/**
 * Text in a PNG, as an `iTXt` chunk (PNG specification, third edition, 11.3.3.4): uncompressed
 * UTF-8 with a keyword. Saved pictures store a note of how they were made in it.
 */

export const pngSignature = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
const chunkOverhead = 12; // length, type, checksum

/** Inserts the text before the end of the picture; `png` must be a PNG. */
export function insertPngText(png: Uint8Array, keyword: string, text: string): Uint8Array {
  const chunk = textChunk(keyword, text);
  const end = png.length - chunkOverhead; // IEND is empty and last
  const out = new Uint8Array(png.length + chunk.length);
  out.set(png.subarray(0, end));
  out.set(chunk, end);
  out.set(png.subarray(end), end + chunk.length);
  return out;
}

/** The text with the keyword; nothing if the bytes are not a PNG or have no such text. */
export function readPngText(bytes: Uint8Array, keyword: string): string | undefined {
  if (pngSignature.some((byte, i) => bytes[i] !== byte)) return undefined;
  const prefix = textPrefix(keyword);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = pngSignature.length;
  while (at + chunkOverhead <= bytes.length) {
    const length = view.getUint32(at);
    if (length > bytes.length - at - chunkOverhead) return undefined;
    const type = decoder.decode(bytes.subarray(at + 4, at + 8));
    const data = bytes.subarray(at + 8, at + 8 + length);
    if (type === 'iTXt' && prefix.every((byte, i) => data[i] === byte)) {
      return decoder.decode(data.subarray(prefix.length));
    }
    at += chunkOverhead + length;
  }
  return undefined;
}

function textChunk(keyword: string, text: string): Uint8Array {
  const prefix = textPrefix(keyword);
  const content = encoder.encode(text);
  const data = new Uint8Array(prefix.length + content.length);
  data.set(prefix);
  data.set(content, prefix.length);
  return pngChunk('iTXt', data);
}

/** A chunk with its length, type and checksum. */
export function pngChunk(type: string, data: Uint8Array): Uint8Array {
  const chunk = new Uint8Array(data.length + chunkOverhead);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, data.length);
  chunk.set(encoder.encode(type), 4);
  chunk.set(data, 8);
  view.setUint32(8 + data.length, crc32(chunk.subarray(4, 8 + data.length)));
  return chunk;
}

/** Keyword, NUL, no compression, method 0, no language, no translated keyword. */
function textPrefix(keyword: string): number[] {
  return [...encoder.encode(keyword), 0, 0, 0, 0, 0];
}

const encoder = new TextEncoder();
const decoder = new TextDecoder('utf-8', { ignoreBOM: true });
