import type { Diagnostic } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import { extensionOf, memoryFile } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { readableExtensions } from '../formats/extensions.ts';
import type { ReadOutcome, ReadProgress } from '../formats/read-characters.ts';
import type { LooseFile } from '../workers/read-characters-task.ts';
import { readBytes } from './read-bytes.ts';
import { runTask } from './run-task.ts';

/** More than this is read on another thread, so that the page stays alive. */
const workerSize = 1024 * 1024;

/** Reads characters here or in a worker; once the signal is aborted the outcome is of no use. */
export async function readFiles(
  files: readonly FileEntry[],
  signal: AbortSignal,
  onProgress: ReadProgress,
): Promise<ReadOutcome> {
  const { loaded, diagnostics } = await loadBytes(files);
  if (signal.aborted) return { characters: [], diagnostics };
  const size = loaded.reduce((sum, { bytes }) => sum + bytes.length, 0);
  const outcome = await (size > workerSize
    ? readInWorker(loaded, signal, onProgress)
    : readHere(loaded, onProgress));
  return { ...outcome, diagnostics: [...diagnostics, ...outcome.diagnostics] };
}

/** The bytes of all that is worth reading; what can't be read is told, not thrown. */
async function loadBytes(
  files: readonly FileEntry[],
): Promise<{ loaded: LooseFile[]; diagnostics: Diagnostic[] }> {
  const loaded: LooseFile[] = [];
  const diagnostics: Diagnostic[] = [];
  for (const file of files) {
    const { path, fault } = file;
    const isRead = fault !== undefined || readableExtensions.includes(extensionOf(path));
    // What nothing reads is in the list of what is not used.
    const bytes = isRead ? await readBytes(file, diagnostics) : new Uint8Array(0);
    if (bytes) loaded.push({ path, bytes });
  }
  return { loaded, diagnostics };
}

/** The readers are loaded at first use: the first picture's are in the worker. */
async function readHere(
  files: readonly LooseFile[],
  onProgress: ReadProgress,
): Promise<ReadOutcome> {
  const { readCharacters } = await loadPart(import('../formats/read-characters.ts'));
  return readCharacters(files.map(asEntry), onProgress);
}

async function readInWorker(
  files: readonly LooseFile[],
  signal: AbortSignal,
  onProgress: ReadProgress,
): Promise<ReadOutcome> {
  // Copies, since the same files may be read again when a part of theirs comes later.
  const copies = files.map(({ path, bytes }) => ({ path, bytes: bytes.slice() }));
  const transfer = copies.map(({ bytes }) => bytes.buffer);
  const outcome = await runTask('read-characters', copies, { signal, onProgress, transfer });
  if (!outcome) return { characters: [], diagnostics: [] };
  return {
    characters: outcome.characters.map(({ character, files: own }) => ({
      character,
      files: own.map(asEntry),
    })),
    diagnostics: outcome.diagnostics,
  };
}

function asEntry({ path, bytes }: LooseFile): FileEntry {
  return memoryFile(path, bytes);
}
