import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import { extensionOf } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { poseFromJson, readPoseJson } from '../formats/pose-json.ts';
import { decodeText } from '../formats/text/decode-text.ts';
import { parsePictureNote, pictureKeyword, type PictureNote } from './picture-note.ts';

interface SortedFiles {
  readonly poses: readonly { readonly path: string; readonly text: string }[];
  readonly notes: readonly PictureNote[];
  /** What may be of characters: textures too. */
  readonly parts: readonly FileEntry[];
}

/** Poses and pictures that Sinew saved are for the open character; the rest may hold characters. */
export async function sortFiles(files: readonly FileEntry[]): Promise<SortedFiles> {
  const poses: { path: string; text: string }[] = [];
  const notes: PictureNote[] = [];
  const parts: FileEntry[] = [];
  for (const file of files) {
    const extension = extensionOf(file.path);
    if (extension === '.json') {
      poses.push({ path: file.path, text: decodeText(await file.bytes()) });
      continue;
    }
    const note = extension === '.png' ? await noteOf(file) : undefined;
    if (note) notes.push(note);
    else parts.push(file);
  }
  return { poses, notes, parts };
}

/** Few users drop pictures, so that the first of ours does not wait for this. */
async function noteOf(file: FileEntry): Promise<PictureNote | undefined> {
  const { readPngText } = await import('../formats/png/text-chunk.ts');
  return parsePictureNote(readPngText(await file.bytes(), pictureKeyword) ?? '');
}

/** The last of the poses that can be used. */
export function readPoses(
  { poses, notes }: Pick<SortedFiles, 'poses' | 'notes'>,
  { skeleton }: Character,
  problems: Diagnostic[],
): Float64Array | undefined {
  const parsed = [
    ...poses.map(({ path, text }) => readPoseJson(path, text, skeleton)),
    ...notes.map(({ name, pose }) => poseFromJson(`${name}.png`, pose, skeleton)),
  ];
  for (const { diagnostics } of parsed) problems.push(...diagnostics);
  return parsed.findLast(({ value }) => value !== undefined)?.value?.q;
}
