import type { Diagnostic } from '../core/diagnostics.ts';
import { baseName, extensionOf } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { openMotion } from '../ui/open-motion.ts';
import type { FileOpener } from './open-files.ts';
import { readBytes } from './read-bytes.ts';
import type { PoseFile } from './sort-files.ts';
import { formats } from '../formats/registry.ts';

/** Files that were sorted, and the rest of them. */
interface Sorted {
  readonly motions: readonly PoseFile[];
  readonly parts: readonly FileEntry[];
}

/**
 * Adds to the motions the `.anim` files that came alone, for a character whose own files they can't
 * complete. The others are clips of the character that they come with.
 */
export async function motionsAmong(
  { motions, parts }: Sorted,
  { selected, openedFiles }: FileOpener,
  problems: Diagnostic[],
): Promise<Sorted> {
  const areAlone = parts.every(({ path }) => extensionOf(path) === '.anim');
  const complete = hasClipFiles(openedFiles?.character.meta.format);
  const isPosable = (selected?.character.skeleton.jointCount ?? 0) > 0;
  if (parts.length === 0 || !areAlone || complete || !isPosable) return { motions, parts };
  const read: PoseFile[] = [];
  for (const file of parts) {
    const bytes = await readBytes(file, problems);
    if (bytes) read.push({ path: file.path, bytes });
  }
  return { motions: [...motions, ...read], parts: [] };
}

/**
 * Opens motions as clips of the selected character, each as a step of undo.
 *
 * @returns what came of the last one, or nothing without motions
 */
export function openMotions(
  { store, session }: FileOpener,
  motions: readonly PoseFile[],
  problems: Diagnostic[],
): string | undefined {
  const said = motions.map(({ path, bytes }) =>
    openMotion({ store, session }, baseName(path), bytes, problems),
  );
  return said.at(-1);
}

/** Whether a character of this format comes with files of clips. */
function hasClipFiles(format: string | undefined): boolean {
  return formats.some(({ id, shape }) => id === format && shape.clips);
}
