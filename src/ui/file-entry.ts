import { headSize } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';

/** A file of the browser; only its head is read until its bytes are asked for. */
export async function fileEntry(file: File, path?: string): Promise<FileEntry> {
  let head = new Uint8Array(0);
  try {
    head = new Uint8Array(await file.slice(0, headSize).arrayBuffer());
  } catch {
    // Moved or deleted since; reading its bytes will say so.
  }
  return {
    path: path ?? (file.webkitRelativePath || file.name),
    size: file.size,
    head,
    bytes: async () => new Uint8Array(await file.arrayBuffer()),
  };
}
