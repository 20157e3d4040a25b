import { headSize } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';

/** A file of the browser; only its head is read until its bytes are asked for. */
export async function fileEntry(file: File): Promise<FileEntry> {
  return {
    path: file.webkitRelativePath || file.name,
    size: file.size,
    head: new Uint8Array(await file.slice(0, headSize).arrayBuffer()),
    bytes: async () => new Uint8Array(await file.arrayBuffer()),
  };
}
