import type { FileEntry } from './format.ts';

export const headSize = 4096;

/** A file whose bytes are at hand. */
export function memoryFile(path: string, bytes: Uint8Array): FileEntry {
  return {
    path,
    size: bytes.length,
    head: bytes.subarray(0, headSize),
    bytes: () => Promise.resolve(bytes),
  };
}

export function baseName(path: string): string {
  return path.slice(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
}

/** Folder and file name without its last ending: "data/Model1" of "data/Model1.skel". */
export function pathStem(path: string): string {
  const extension = extensionOf(path);
  return extension === '' ? path : path.slice(0, -extension.length);
}

/** With the dot, lower case; empty where there is none. */
export function extensionOf(path: string): string {
  const name = baseName(path);
  const dot = name.lastIndexOf('.');
  return dot <= 0 ? '' : name.slice(dot).toLowerCase();
}
