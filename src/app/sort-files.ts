import type { Diagnostic } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import { extensionOf } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { decodeText } from '../formats/text/decode-text.ts';
import { pictureKeyword } from './picture-note.ts';
import { readBytes } from './read-bytes.ts';

export interface JsonText {
  /** Of the file that holds it. */
  readonly path: string;
  readonly text: string;
}

interface SortedFiles {
  readonly poses: readonly JsonText[];
  /** Of pictures that Sinew saved, not yet read. */
  readonly notes: readonly JsonText[];
  /** What may be of characters: textures too. */
  readonly parts: readonly FileEntry[];
  /** Of what can't be read. */
  readonly diagnostics: readonly Diagnostic[];
}

/** Poses and pictures that Sinew saved are for the open character; the rest may hold characters. */
export async function sortFiles(files: readonly FileEntry[]): Promise<SortedFiles> {
  const poses: JsonText[] = [];
  const notes: JsonText[] = [];
  const parts: FileEntry[] = [];
  const diagnostics: Diagnostic[] = [];
  for (const file of files) {
    const { path } = file;
    const extension = extensionOf(path);
    if (extension !== '.json' && extension !== '.png') {
      parts.push(file);
      continue;
    }
    const bytes = await readBytes(file, diagnostics);
    if (!bytes) continue;
    if (extension === '.json') {
      poses.push({ path, text: decodeText(bytes) });
      continue;
    }
    const text = await noteOf(bytes);
    if (text === undefined) parts.push(file);
    else notes.push({ path, text });
  }
  return { poses, notes, parts, diagnostics };
}

/** Few users drop pictures, so that the first of ours does not wait for this. */
async function noteOf(png: Uint8Array): Promise<string | undefined> {
  const { readPngText } = await loadPart(import('../formats/png/text-chunk.ts'));
  return readPngText(png, pictureKeyword);
}
