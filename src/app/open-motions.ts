import type { Diagnostic } from '../core/diagnostics.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import { bindClip } from '../document/edits.ts';
import type { Actor } from '../document/scene.ts';
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
  const complete = hasClipFiles(openedFiles?.character.meta.format);
  const isPosable = (selected?.character.skeleton.jointCount ?? 0) > 0;
  if (!areMotions(parts) || complete || !isPosable) return { motions, parts };
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

/** Whether nothing but `.anim` files came. */
export function areMotions(parts: readonly FileEntry[]): boolean {
  return parts.length > 0 && parts.every(({ path }) => extensionOf(path) === '.anim');
}

/** The clip of the last file, if the character did not have it before. */
export function clipOfLast(
  parts: readonly FileEntry[],
  { clips }: Partial<Pick<Actor, 'clips'>>,
  before: Pick<Actor, 'clips'>,
): ClipParts | undefined {
  const clip = clips?.find(({ file }) => file === baseName(parts.at(-1)!.path));
  return before.clips.some(({ name }) => name === clip?.name) ? undefined : clip;
}

/** Lets the selected character show the start of a clip that came for it. */
export function showClip({ store, session, selected }: FileOpener, clip: ClipParts): void {
  if (!selected) return;
  session.playing.value = false;
  session.clipIndex.value = selected.clips.indexOf(clip);
  session.clipTime.value = clip.start;
  store.amend(bindClip(selected.id, session.clipIndex.value));
}

/** Whether a character of this format comes with files of clips. */
function hasClipFiles(format: string | undefined): boolean {
  return formats.some(({ id, shape }) => id === format && shape.clips);
}
