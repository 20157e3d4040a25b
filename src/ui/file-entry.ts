import { headSize } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';

/** Wraps a file of the browser. Only its head is read until its bytes are requested. */
export async function fileEntry(file: File, path?: string): Promise<FileEntry> {
  const named = path ?? (file.webkitRelativePath || file.name);
  try {
    return {
      path: named,
      size: file.size,
      head: new Uint8Array(await file.slice(0, headSize).arrayBuffer()),
      bytes: async () => new Uint8Array(await file.arrayBuffer()),
    };
  } catch (error) {
    return unreadableEntry(named, error);
  }
}

/** Represents a file or folder that can't be read, so that the user is told. */
export function unreadableEntry(path: string, error: unknown): FileEntry {
  const empty = new Uint8Array(0);
  const bytes = () => Promise.resolve(empty);
  return { path, size: 0, head: empty, bytes, fault: readFault(error) };
}

/** The reason why the browser can't read a file, in words. */
export function readFault(error: unknown): string {
  const isGone = error instanceof DOMException && error.name === 'NotFoundError';
  return isGone ? 'nothing there any more' : 'one that the browser may not read, or that changed';
}
