import { deflateSync, Inflate } from 'fflate';
import { fromBase64url, toBase64url } from './base64url.ts';

/** What the hash of a link begins with; the number is the version of this form. */
const prefix = '#s=1.';

/** In characters. Longer addresses are cut by programs that pass them on. */
export const longestLink = 8 * 1024;

/** In bytes. A link unpacks to at most a thousand times its size, which could stop the page. */
const largestText = 1024 * 1024;

/** Returns the hash that carries a scene: its JSON as UTF-8, raw Deflate and base64url. */
export function linkOfScene(text: string): string {
  return prefix + toBase64url(deflateSync(new TextEncoder().encode(text), { level: 9 }));
}

/** Returns the JSON that a hash carries, or what is wrong with it. */
export function sceneOfLink(hash: string): { readonly text: string } | { readonly fault: string } {
  const version = /^#s=(\d+)\./.exec(hash)?.[1];
  if (version !== undefined && Number(version) > 1) return { fault: 'a newer Sinew made it' };
  if (!hash.startsWith(prefix)) return { fault: 'it is not one of a scene' };
  const packed = fromBase64url(hash.slice(prefix.length));
  const bytes = packed && packed.length > 0 ? inflate(packed) : undefined;
  if (!bytes) return { fault: 'it is damaged or cut' };
  try {
    return { text: new TextDecoder('utf-8', { fatal: true }).decode(bytes) };
  } catch {
    return { fault: 'it is damaged or cut' };
  }
}

/** Returns nothing if the data is not Deflate, ends early, or is too large when it is unpacked. */
function inflate(packed: Uint8Array): Uint8Array | undefined {
  const pieces: Uint8Array[] = [];
  let length = 0;
  const inflater = new Inflate((piece) => {
    length += piece.length;
    if (length > largestText) throw new Error('too large');
    pieces.push(piece);
  });
  try {
    for (let at = 0; at < packed.length; at += step) {
      inflater.push(packed.subarray(at, at + step), at + step >= packed.length);
    }
  } catch {
    return undefined;
  }
  const bytes = new Uint8Array(length);
  let at = 0;
  for (const piece of pieces) {
    bytes.set(piece, at);
    at += piece.length;
  }
  return bytes;
}

/** In packed bytes, of which each unpacks to at most a thousand. */
const step = 1024;
