import { loadPart } from '../core/failure.ts';
import { memoryFile } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import type { ReadOutcome, ReadProgress } from '../formats/read-characters.ts';
import type { LooseFile } from '../workers/read-characters-task.ts';

/** In bytes. More than this is read in a worker, so that the page stays responsive. */
const workerSize = 1024 * 1024;

/**
 * Reads characters on this thread or in a worker. If the signal is aborted, the result must not be
 * used.
 */
export async function readFiles(
  files: readonly LooseFile[],
  signal: AbortSignal,
  onProgress: ReadProgress,
): Promise<ReadOutcome> {
  const size = files.reduce((sum, { bytes }) => sum + bytes.length, 0);
  if (size > workerSize) {
    const { readInWorker } = await loadPart(import('./read-in-worker.ts'));
    return readInWorker(files, signal, onProgress);
  }
  const readHere = await loadReadHere();
  return readHere(files, onProgress);
}

/** Reads characters on this thread. */
export type ReadHere = (
  files: readonly LooseFile[],
  onProgress: ReadProgress,
) => Promise<ReadOutcome>;

/**
 * Loads what reads characters on this thread, which is code that the page shares. The page gets its
 * turn between two files.
 */
async function loadReadHere(): Promise<ReadHere> {
  const { readCharacters } = await loadPart(import('../formats/read-characters.ts'));
  return (files, onProgress) => readCharacters(files.map(asPatientEntry), onProgress);
}

/**
 * Loads the same for the first picture, with the readers that read all files with these names. Before
 * it, the page has nothing else to do.
 */
export async function loadReadFirst(names: readonly string[]): Promise<ReadHere> {
  const { loadReaders, readCharacters } = await loadPart(import('../formats/read-characters.ts'));
  await loadReaders(names.map((name) => name.replace(/\.gz$/, '')));
  return (files, onProgress) => readCharacters(files.map(asEntry), onProgress);
}

/** A file before which the page gets its turn, so that it answers between two files. */
function asPatientEntry(file: LooseFile): FileEntry {
  const entry = asEntry(file);
  const bytes = async (): Promise<Uint8Array> => {
    await new Promise((resolve) => setTimeout(resolve));
    return entry.bytes();
  };
  return { ...entry, bytes };
}

function asEntry({ path, bytes }: LooseFile): FileEntry {
  return memoryFile(path, bytes);
}
