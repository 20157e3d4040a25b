import type { FileEntry } from '../formats/format.ts';
import { isJunk } from '../formats/junk.ts';
import { fileEntry, unreadableEntry } from './file-entry.ts';

/** Limits the listing, because a dropped folder may be the root of a disk. */
const largestCount = 10_000;

/**
 * Returns the files of a drop, including those in folders. Entries that can't be read are included
 * and report why.
 *
 * @param entries of the same drop; they distinguish folders from files
 */
export function droppedFiles(
  files: readonly File[],
  entries: readonly (FileSystemEntry | null)[],
): Promise<FileEntry[]> {
  const hasFolder = entries.some((entry) => entry?.isDirectory);
  if (!hasFolder) return Promise.all(files.map((file) => fileEntry(file)));
  return walk(entries.filter((entry) => entry !== null));
}

async function walk(entries: readonly FileSystemEntry[]): Promise<FileEntry[]> {
  const found: FileEntry[] = [];
  const pending = [...entries].reverse();
  for (let entry = pending.pop(); entry; entry = pending.pop()) {
    if (isJunk(entry.name)) continue;
    const path = entry.fullPath.replace(/^\//, '');
    try {
      if (isFolder(entry)) pending.push(...(await listFolder(entry)).reverse());
      else if (isFile(entry)) found.push(await fileEntry(await fileOf(entry), path));
    } catch (error) {
      found.push(unreadableEntry(path, error));
    }
    if (found.length >= largestCount) break;
  }
  return found;
}

// Browsers do not expose constructors of these types for `instanceof`, so the entries' own flags
// are used.
function isFolder(entry: FileSystemEntry): entry is FileSystemDirectoryEntry {
  return entry.isDirectory;
}

function isFile(entry: FileSystemEntry): entry is FileSystemFileEntry {
  return entry.isFile;
}

function fileOf(entry: FileSystemFileEntry): Promise<File> {
  return new Promise((resolve, reject) => {
    entry.file(resolve, reject);
  });
}

/** A directory reader returns entries in batches, with an empty batch at the end. */
async function listFolder(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    const batch = await new Promise<FileSystemEntry[]>((resolve, reject) => {
      reader.readEntries(resolve, reject);
    });
    if (batch.length === 0) return all;
    all.push(...batch);
  }
}
