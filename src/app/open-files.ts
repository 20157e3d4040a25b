import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import { openCharacter, setPose } from '../document/commands.ts';
import { type CharacterState, selectedCharacter } from '../document/document.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import { baseName, extensionOf } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { readPngText } from '../formats/png/text-chunk.ts';
import { poseFromJson, readPoseJson } from '../formats/pose-json.ts';
import type { ReadCharacter, ReadProgress } from '../formats/read-characters.ts';
import { decodeText } from '../formats/text/decode-text.ts';
import { methods } from '../skinning/registry.ts';
import { parsePictureNote, pictureKeyword, type PictureNote } from './picture-note.ts';
import { readFiles } from './read-files.ts';

/** What became of files that were dropped, chosen or fetched. */
export interface OpenOutcome {
  /** All that were found; the first of them is open. */
  readonly found: readonly ReadCharacter[];
  readonly opened: Character | null;
  /** The same files once more: pose and camera stay. */
  readonly reopened: boolean;
  readonly posed: boolean;
}

/**
 * Opens files: a character takes the place of the selected one, a pose is set on it, each one step
 * of undo. Parts that the open character lacks complete it; its own files, changed, renew it.
 */
export class FileOpener {
  private readonly store: Store;
  private readonly session: Session;
  /** The files of each character that was opened, so that later drops can complete or renew it. */
  private readonly filesOf = new WeakMap<Character, readonly FileEntry[]>();

  constructor(store: Store, session: Session) {
    this.store = store;
    this.session = session;
  }

  /**
   * @param signal aborted where the user cancels, or where later files take over
   * @param openBundled opens a bundled character, for pictures that remember one
   * @returns nothing where it was aborted; the page is then as it was
   */
  async open(
    files: readonly FileEntry[],
    signal: AbortSignal,
    onProgress: ReadProgress,
    openBundled: (id: string) => Promise<void>,
  ): Promise<OpenOutcome | undefined> {
    const { poses, notes, parts, problems } = await sortFiles(files);
    const completed = this.completed(parts);
    const { characters, diagnostics } =
      completed.length > 0
        ? await readFiles(completed, signal, onProgress)
        : { characters: [], diagnostics: [] };
    if (signal.aborted) return undefined;
    problems.push(...diagnostics);
    const first = characters[0];
    const remembered = notes.at(-1)?.bundled;
    if (!first && remembered !== undefined) await openBundled(remembered);
    const reopened = first !== undefined && this.renews(first);
    const character = first?.character ?? this.selected?.character;
    const q = character && readPoses(poses, notes, character, problems);
    if (first) {
      this.show(first, q);
      problems.push(...missingParts(first.character));
    } else if (q && this.selected) {
      this.store.dispatch(setPose(this.selected.id, q, 'Open a pose'));
    }
    this.session.problems.value = problems;
    return {
      found: characters,
      opened: first?.character ?? null,
      reopened,
      posed: q !== undefined,
    };
  }

  /** Opens a character that was read, at the given pose, its own as it stands, or the file's. */
  show(read: ReadCharacter, q?: Float64Array): void {
    const kept = this.renews(read) ? this.selected?.q : undefined;
    this.filesOf.set(read.character, read.files);
    const method = this.selected?.method ?? methods[0]!.id;
    this.store.dispatch(openCharacter(read.character, method, q ?? kept));
    if (kept) return;
    this.session.selectedJoint.value = null;
    this.session.hoveredJoint.value = null;
    this.session.activeDof.value = null;
  }

  private get selected(): CharacterState | undefined {
    return selectedCharacter(this.store.document.value);
  }

  /**
   * The files, with those of the open character where all that came is what it lacks, or its own files
   * once more.
   */
  private completed(files: readonly FileEntry[]): readonly FileEntry[] {
    const character = this.selected?.character;
    const before = character && this.filesOf.get(character);
    if (!before || files.length === 0) return files;
    const nameOf = ({ path }: FileEntry): string => baseName(path).toLowerCase();
    const [oldNames, newNames] = [before.map(nameOf), files.map(nameOf)];
    const belong = files.every(
      (file) =>
        character.missing.includes(extensionOf(file.path)) || oldNames.includes(nameOf(file)),
    );
    if (!belong) return files;
    return [...before.filter((file) => !newNames.includes(nameOf(file))), ...files];
  }

  /** Whether a character came of the open one's files, or of them and more, with the same joints. */
  private renews({ character, files }: ReadCharacter): boolean {
    const before = this.selected?.character;
    const old = before && this.filesOf.get(before);
    if (!old) return false;
    const paths = new Set(files.map(({ path }) => baseName(path).toLowerCase()));
    const { names } = character.skeleton;
    const sameJoints =
      names.length === before.skeleton.names.length &&
      names.every((name, joint) => name === before.skeleton.names[joint]);
    return sameJoints && old.every(({ path }) => paths.has(baseName(path).toLowerCase()));
  }
}

interface SortedFiles {
  readonly poses: readonly { readonly path: string; readonly text: string }[];
  readonly notes: readonly PictureNote[];
  readonly parts: readonly FileEntry[];
  readonly problems: Diagnostic[];
}

/** What the character's files leave out, with the way to add it. */
function missingParts({ name, missing }: Character): Diagnostic[] {
  return missing.map((ending) => ({
    severity: 'warning',
    code: 'file/missing',
    file: name,
    expected: `${name}${ending}`,
    found: 'no such file',
    effect: 'the rest is shown; drop the file here to complete the character',
  }));
}

/** Poses and pictures are for the open character; the rest may hold characters. */
async function sortFiles(files: readonly FileEntry[]): Promise<SortedFiles> {
  const poses: { path: string; text: string }[] = [];
  const notes: PictureNote[] = [];
  const parts: FileEntry[] = [];
  const problems: Diagnostic[] = [];
  for (const file of files) {
    const extension = extensionOf(file.path);
    if (extension === '.json') {
      poses.push({ path: file.path, text: decodeText(await file.bytes()) });
    } else if (extension === '.png') {
      const note = parsePictureNote(readPngText(await file.bytes(), pictureKeyword) ?? '');
      if (note) notes.push(note);
      else problems.push(plainPicture(file.path));
    } else parts.push(file);
  }
  return { poses, notes, parts, problems };
}

function plainPicture(file: string): Diagnostic {
  return {
    severity: 'warning',
    code: 'file/unknown',
    file,
    expected: 'a PNG that Sinew saved',
    found: 'a picture without its note',
    effect: 'the file is not used',
  };
}

/** The last of the poses that can be used. */
function readPoses(
  poses: SortedFiles['poses'],
  notes: readonly PictureNote[],
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
