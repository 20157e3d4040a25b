import { loadPart } from '../core/failure.ts';
import { memoryFile } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import type { ReadOutcome, ReadProgress } from '../formats/read-characters.ts';
import type { LooseFile } from '../workers/read-characters-task.ts';
import { runTask } from './run-task.ts';

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
  if (size > workerSize) return readInWorker(files, signal, onProgress);
  const readHere = await loadReadHere();
  return readHere(files, onProgress);
}

/** Reads characters on this thread. */
export type ReadHere = (
  files: readonly LooseFile[],
  onProgress: ReadProgress,
) => Promise<ReadOutcome>;

/**
 * Loads what reads characters on this thread: code that the page shares, and the readers that read
 * all files with these names.
 */
export async function loadReadHere(names: readonly string[] = []): Promise<ReadHere> {
  const { loadReaders, readCharacters } = await loadPart(import('../formats/read-characters.ts'));
  await loadReaders(names.map((name) => name.replace(/\.gz$/, '')));
  return (files, onProgress) => readCharacters(files.map(asPatientEntry), onProgress);
}

async function readInWorker(
  files: readonly LooseFile[],
  signal: AbortSignal,
  onProgress: ReadProgress,
): Promise<ReadOutcome> {
  // The bytes are copied, because the same files may be read again when a missing file arrives
  // later.
  const copies: { path: string; bytes: Uint8Array<ArrayBuffer> }[] = [];
  for (const { path, bytes } of files) copies.push({ path, bytes: await copyInSteps(bytes) });
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

/** In bytes. A step of this size takes some milliseconds, so that the page stays responsive. */
const copyStep = 16 * 1024 * 1024;

async function copyInSteps(bytes: Uint8Array): Promise<Uint8Array<ArrayBuffer>> {
  const copy = new Uint8Array(bytes.length);
  for (let at = 0; at < bytes.length; at += copyStep) {
    if (at > 0) await new Promise((resolve) => setTimeout(resolve));
    copy.set(bytes.subarray(at, at + copyStep), at);
  }
  return copy;
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
