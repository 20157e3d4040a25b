import type { FileEntry } from '../../formats/format.ts';
import type { ReadCharacter } from '../../formats/read-characters.ts';

/** Returns the characters with files whose SHA-256 is known, by which scenes refer to them. */
export async function withHashes(read: readonly ReadCharacter[]): Promise<ReadCharacter[]> {
  const hashed: ReadCharacter[] = [];
  for (const { character, files } of read) {
    hashed.push({ character, files: await Promise.all(files.map(withHash)) });
  }
  return hashed;
}

/** Returns the file with its SHA-256, where the browser computes it: on secure pages alone. */
export async function withHash(file: FileEntry): Promise<FileEntry> {
  const { subtle } = crypto as { readonly subtle?: SubtleCrypto };
  if (!subtle || file.sha256 !== undefined) return file;
  const bytes = await file.bytes();
  const digest = await subtle.digest('SHA-256', bytes as BufferSource);
  return { ...file, sha256: hexadecimal(new Uint8Array(digest)) };
}

function hexadecimal(bytes: Uint8Array): string {
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}
