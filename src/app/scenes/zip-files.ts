import { Zip, ZipDeflate, ZipPassThrough } from 'fflate';
import { extensionOf } from '../../formats/file-entry.ts';
import type { OutputFile } from '../../formats/format.ts';
import type { ReadProgress } from '../../formats/read-characters.ts';

/** In bytes. Packing so many takes some milliseconds, after which the page gets its turn. */
const step = 512 * 1024;

/** Images that are packed already. */
const packedExtensions = ['.png', '.jpg', '.jpeg'];

/**
 * Packs files into a zip archive; nothing if the signal is aborted. The page answers meanwhile.
 */
export async function zipFiles(
  files: readonly OutputFile[],
  signal: AbortSignal,
  onProgress: ReadProgress,
): Promise<Blob | undefined> {
  const parts: BlobPart[] = [];
  const faults: Error[] = [];
  const archive = new Zip((error, part) => {
    if (error) faults.push(error);
    else parts.push(part);
  });
  const total = files.reduce((sum, { bytes }) => sum + bytes.length, 0);
  let done = 0;
  for (const { path, bytes } of files) {
    const isPacked = packedExtensions.includes(extensionOf(path));
    const entry = isPacked ? new ZipPassThrough(path) : new ZipDeflate(path);
    archive.add(entry);
    for (let at = 0; at === 0 || at < bytes.length; at += step) {
      if (done > 0) await new Promise((resolve) => setTimeout(resolve));
      if (signal.aborted) return undefined;
      onProgress(path, total > 0 ? done / total : 0);
      const piece = bytes.subarray(at, at + step);
      entry.push(piece, at + step >= bytes.length);
      done += piece.length;
    }
  }
  archive.end();
  const [fault] = faults;
  if (fault) throw fault;
  return new Blob(parts, { type: 'application/zip' });
}
