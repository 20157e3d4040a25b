import { Inflate } from 'fflate';
import { crc32 } from '../crc32.ts';
import type { ZipEntry } from './directory.ts';

const stored = 0;
const deflated = 8;

/** A piece unpacks to at most a thousand times its size, so that a false size is detected soon. */
const pieceSize = 16 * 1024;

/** Returns the file's bytes, never more than its entry states, or what is wrong with it. */
export function unpack(entry: ZipEntry): Uint8Array | string {
  const { isEncrypted, method, packed, size, checksum } = entry;
  if (isEncrypted) return 'under a password';
  if (method !== stored && method !== deflated) return `packed by method ${method}`;
  if (!packed) return 'not all in the archive';
  const bytes = method === stored ? packed : inflate(packed, size);
  return bytes?.length === size && crc32(bytes) === checksum ? bytes : 'broken';
}

/** Returns nothing if the data is not Deflate, ends early, or unpacks to more than `size`. */
function inflate(packed: Uint8Array, size: number): Uint8Array | undefined {
  const bytes = new Uint8Array(size);
  let length = 0;
  const inflater = new Inflate((piece) => {
    if (piece.length > size - length) throw new Error('more than its entry says');
    bytes.set(piece, length);
    length += piece.length;
  });
  try {
    for (let at = 0; at < packed.length; at += pieceSize) {
      inflater.push(packed.subarray(at, at + pieceSize), at + pieceSize >= packed.length);
    }
  } catch {
    return undefined;
  }
  return length === size ? bytes : undefined;
}
