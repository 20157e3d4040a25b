import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { gzipSync } from 'node:zlib';

/**
 * Writes text as a gzip file and returns its size in bytes. Node stores no modification time and no
 * name in the header, so the same text gives the same bytes on every run. Byte 9 (the operating
 * system) is set to 255, unknown, because it is the one byte that would differ between machines.
 */
export function writeGzipText(path: string, text: string): number {
  const bytes = gzipSync(Buffer.from(text, 'utf8'), { level: 9, memLevel: 9 });
  bytes.fill(0, 4, 8);
  bytes[9] = 255;
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, bytes);
  return bytes.length;
}
