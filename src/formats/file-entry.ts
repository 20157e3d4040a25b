import type { FileEntry } from './format.ts';
import { startOfTokens } from './text/head-tokens.ts';

export const headSize = 4096;

/** A file whose bytes are already in memory. */
export function memoryFile(path: string, bytes: Uint8Array): FileEntry {
  const start = startOfTokens(bytes);
  return {
    path,
    size: bytes.length,
    head: bytes.subarray(start, start + headSize),
    bytes: () => Promise.resolve(bytes),
  };
}

export function baseName(path: string): string {
  return path.slice(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
}

/** The path without its last extension: "data/Model1" for "data/Model1.skel". */
export function pathStem(path: string): string {
  const extension = extensionOf(path);
  return extension === '' ? path : path.slice(0, -extension.length);
}

/** The extension with the dot, in lower case; empty if there is none. */
export function extensionOf(path: string): string {
  const name = baseName(path);
  const dot = name.lastIndexOf('.');
  return dot <= 0 ? '' : name.slice(dot).toLowerCase();
}
