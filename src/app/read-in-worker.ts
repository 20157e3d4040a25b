import { memoryFile } from '../formats/file-entry.ts';
import type { ReadOutcome, ReadProgress } from '../formats/read-characters.ts';
import type { LooseFile } from '../workers/read-characters-task.ts';
import { runTask } from './run-task.ts';

/** Reads characters in a worker; none, if the signal is aborted. */
export async function readInWorker(
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
      files: own.map(({ path, bytes }) => memoryFile(path, bytes)),
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
