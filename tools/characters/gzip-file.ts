import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { gzipSync } from 'node:zlib';

/**
 * Writes text or bytes as a gzip file and returns its size in bytes. Node stores no modification time and no
 * name in the header, so the same content gives the same bytes on every run. Byte 9 (the operating
 * system) is set to 255, unknown, because it is the one byte that would differ between machines.
 */
export function writeGzip(path: string, content: string | Uint8Array): number {
  const bytes = gzipSync(content, { level: 9, memLevel: 9 });
  bytes.fill(0, 4, 8);
  bytes[9] = 255;
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, bytes);
  return bytes.length;
}
