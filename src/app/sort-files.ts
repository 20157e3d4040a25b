import { extensionOf } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { decodeText } from '../formats/text/decode-text.ts';
import { pictureKeyword } from './picture-note.ts';

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
}

/** Poses and pictures that Sinew saved are for the open character; the rest may hold characters. */
export async function sortFiles(files: readonly FileEntry[]): Promise<SortedFiles> {
  const poses: JsonText[] = [];
  const notes: JsonText[] = [];
  const parts: FileEntry[] = [];
  for (const file of files) {
    const { path } = file;
    const extension = extensionOf(path);
    if (extension === '.json') {
      poses.push({ path, text: decodeText(await file.bytes()) });
      continue;
    }
    const text = extension === '.png' ? await noteOf(file) : undefined;
    if (text === undefined) parts.push(file);
    else notes.push({ path, text });
  }
  return { poses, notes, parts };
}

/** Few users drop pictures, so that the first of ours does not wait for this. */
async function noteOf(file: FileEntry): Promise<string | undefined> {
  const { readPngText } = await import('../formats/png/text-chunk.ts');
  return readPngText(await file.bytes(), pictureKeyword);
}
