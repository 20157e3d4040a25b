import type { Character } from '../core/character.ts';
import { type Diagnostic, printable } from '../core/diagnostics.ts';
import { setPoseAndShape } from '../document/saved-poses.ts';
import { restPose, type Pose } from '../core/pose.ts';
import { sourceOf } from '../document/scene.ts';
import type { FileEntry } from '../formats/format.ts';
import { decodePose } from '../formats/pose-json.ts';
import { poseFormatOf } from '../formats/pose-formats.ts';
import type { ReadCharacter, ReadProgress } from '../formats/read-characters.ts';
import { areImages, coverWithImage } from './dropped-image.ts';
import type { FileOpener, OpenOutcome } from './open-files.ts';
import { areMotions, clipOfLast, motionsAmong, openMotions, showClip } from './open-motions.ts';
import { loadBytes } from './read-bytes.ts';
import { readFiles } from './read-files.ts';
import {
  areCompanions,
  completeFiles,
  keptState,
  missingParts,
  renews,
  weightsText,
} from './renewal.ts';
import { readPictureNote, type ReadNote } from './read-picture-note.ts';
import { withHashes } from './scenes/hash-files.ts';
import { type PoseFile, sortFiles } from './sort-files.ts';

interface OwnFilesOptions {
  /** Aborted when the user cancels, or when a later opening replaces this one. */
  readonly signal: AbortSignal;
  readonly onProgress: ReadProgress;
  /** Opens a bundled character as a part of this opening, for pictures that remember one. */
  readonly openBundled: (id: string) => Promise<void>;
  /**
   * Whether the files are added beside the others; then they neither complete nor update the open
   * character. What only adds to a character goes to the open one in any case.
   */
  readonly add: boolean;
  /** Asks whether other characters are added, if that is not decided; null if for neither. */
  readonly ask?: (found: readonly ReadCharacter[]) => Promise<boolean | null>;
}

/**
 * Opens the user's own files. This part is loaded when the first files arrive, because the first
 * picture shows a bundled character.
 *
 * @returns nothing if the opening was aborted; the page is then as it was
 */
export async function openOwnFiles(
  opener: FileOpener,
  files: readonly FileEntry[],
  { signal, onProgress, openBundled, add: addAll, ask }: OwnFilesOptions,
): Promise<OpenOutcome | undefined> {
  // This is checked after each await, because the signal may change during any of them.
  const isOver = (): boolean => signal.aborted;
  const sorted = await sortFiles(files);
  const { poses, notes: pictures, diagnostics: unreadable } = sorted;
  const notes = pictures.map(readPictureNote);
  const unloadedMotions: Diagnostic[] = [];
  const { motions, parts } = await motionsAmong(sorted, opener, unloadedMotions);
  const open = addAll && !areCompanions(parts) ? undefined : opener.openedFiles;
  const completed = completeFiles(parts, open);
  const images = areImages(completed) ? completed : [];
  const { loaded, diagnostics: unloaded } = await loadBytes(images.length > 0 ? [] : completed);
  if (isOver()) return undefined;
  const { characters: read, diagnostics } =
    images.length > 0
      ? { characters: [], diagnostics: [] }
      : await readFiles(loaded, signal, onProgress);
  const characters = await withHashes(read);
  await opener.prepare(characters);
  if (isOver()) return undefined;
  const problems = [...unreadable, ...unloadedMotions, ...unloaded, ...diagnostics];
  const cover = await coverWithImage(opener, images, signal, problems);
  if (isOver()) return undefined;
  const [first] = characters;
  const remembered = notes.at(-1)?.bundled;
  if (!first && remembered !== undefined) {
    await openBundled(remembered);
    if (isOver()) return undefined;
  }
  const renewed = first && renews(first, open) ? opener.selected : undefined;
  const isNew = first !== undefined && completed === parts && !renewed;
  const add = ask && isNew && opener.isReplacing ? await ask(characters) : addAll;
  if (add === null || isOver()) return undefined;
  const shown = first ? atRest(first.character) : opener.shownPose;
  const character = first?.character ?? opener.selected?.character;
  const pose =
    character && shown && (await readPoses({ poses, notes }, character, shown, problems));
  if (isOver()) return undefined;
  problems.push(...notes.flatMap(({ log }) => log.diagnostics));
  const kept = first && renewed ? keptState(renewed, first.character) : undefined;
  const newClip = kept && areMotions(parts) ? clipOfLast(parts, kept, renewed!) : undefined;
  if (first && renewed) {
    opener.renew(first, renewed, {
      source: sourceOf(first.files),
      ...kept,
      ...(pose && { ...pose, clip: null }),
    });
    if (newClip) showClip(opener, newClip);
  } else if (first) {
    opener.showAll(characters, { add }, pose);
    const { showSkeleton } = opener.session;
    // Whatever is switched on, something of a new character is seen.
    showSkeleton.value ||= characters.every(({ character: { mesh } }) => mesh.pointCount === 0);
  } else if (pose && opener.selected) {
    const { id, morphWeights } = opener.selected;
    opener.store.dispatch(setPoseAndShape(id, { morphWeights, ...pose }, 'Open a pose'));
  }
  const motion = openMotions(opener, motions, problems);
  problems.push(...characters.flatMap((each) => missingParts(each.character)));
  opener.session.problems.value = problems;
  return {
    found: characters,
    opened: first?.character ?? null,
    ...(first &&
      renewed && {
        kept: newClip
          ? `its motion ${printable(newClip.name, 40)} is shown`
          : `pose and camera kept${weightsText(renewed, first.character)}`,
      }),
    posed: pose !== undefined,
    ...(motion !== undefined && { motion }),
    ...(cover !== undefined && { cover }),
    added: add && !renewed,
  };
}

function atRest({ skeleton, morphs }: Character): Required<Pose> {
  return { ...restPose(skeleton), morphWeights: new Float64Array(morphs.length) };
}

/**
 * Returns the last of the poses that can be used.
 *
 * @param shown what the character shows, onto which a part of a pose is put
 */
async function readPoses(
  { poses, notes }: { readonly poses: readonly PoseFile[]; readonly notes: readonly ReadNote[] },
  character: Character,
  shown: Required<Pose>,
  problems: Diagnostic[],
): Promise<Pose | undefined> {
  const ofFiles = await Promise.all(
    poses.map(async ({ path, bytes }) => {
      const { read } = await poseFormatOf(path)!.load();
      return read(path, bytes, character, shown);
    }),
  );
  for (const { diagnostics } of ofFiles) problems.push(...diagnostics);
  const ofNotes = notes.flatMap(({ pose }) => (pose ? [decodePose(pose, character.skeleton)] : []));
  return [...ofFiles, ...ofNotes].findLast(({ value }) => value !== undefined)?.value;
}
