import type { Diagnostic } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import { extensionOf } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { decodeText } from '../formats/text/decode-text.ts';
import { poseFormatOf } from '../formats/pose-formats.ts';
import { pictureKeyword } from './picture-note.ts';
import { readBytes } from './read-bytes.ts';

export interface JsonText {
  /** The path of the file that contains the text. */
  readonly path: string;
  readonly text: string;
}

/** A file with a pose, in one of the formats of poses. */
export interface PoseFile {
  readonly path: string;
  readonly bytes: Uint8Array;
}

interface SortedFiles {
  readonly poses: readonly PoseFile[];
  /** MOTION.json files. */
  readonly motions: readonly PoseFile[];
  /** The notes of pictures that Sinew saved, not yet parsed. */
  readonly notes: readonly JsonText[];
  /** Files that may be parts of characters, including textures. */
  readonly parts: readonly FileEntry[];
  /** Problems of files that can't be read. */
  readonly diagnostics: readonly Diagnostic[];
}

/**
 * Separates poses and pictures saved by Sinew, which apply to the open character, from files that
 * may contain characters.
 */
export async function sortFiles(files: readonly FileEntry[]): Promise<SortedFiles> {
  const poses: PoseFile[] = [];
  const motions: PoseFile[] = [];
  const notes: JsonText[] = [];
  const parts: FileEntry[] = [];
  const diagnostics: Diagnostic[] = [];
  for (const file of files) {
    const { path } = file;
    const isPose = poseFormatOf(path) !== undefined;
    if (!isPose && extensionOf(path) !== '.png') {
      parts.push(file);
      continue;
    }
    const bytes = await readBytes(file, diagnostics);
    if (!bytes) continue;
    if (isPose) {
      if (await isMotion(path, bytes)) motions.push({ path, bytes });
      else poses.push({ path, bytes });
      continue;
    }
    const text = await noteOf(bytes);
    if (text === undefined) parts.push(file);
    else notes.push({ path, text });
  }
  return { poses, motions, notes, parts, diagnostics };
}

/** Whether a JSON file describes a motion; what knows is loaded at the first JSON file. */
async function isMotion(path: string, bytes: Uint8Array): Promise<boolean> {
  if (extensionOf(path) !== '.json') return false;
  const { isMotionText } = await loadPart(import('../ui/open-motion.ts'));
  return isMotionText(decodeText(bytes));
}

/** Few users drop pictures, so the reader is loaded at first use. */
async function noteOf(png: Uint8Array): Promise<string | undefined> {
  const { readPngText } = await loadPart(import('../formats/png/text-chunk.ts'));
  return readPngText(png, pictureKeyword);
}
