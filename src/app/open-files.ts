import { type Diagnostic, hasErrors } from '../core/diagnostics.ts';
import type { Character } from '../core/character.ts';
import { openCharacter, setPose } from '../document/commands.ts';
import { selectedCharacter } from '../document/document.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import { extensionOf } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { readPoseJson } from '../formats/pose-json.ts';
import { readCharacters } from '../formats/read-characters.ts';
import { decodeText } from '../formats/text/check-text.ts';
import { methods } from '../skinning/registry.ts';

/** What became of files that were dropped, chosen or fetched. */
export interface OpenOutcome {
  readonly character: Character | null;
  readonly posed: boolean;
  readonly diagnostics: readonly Diagnostic[];
}

/**
 * Opens files: a character takes the place of the selected one, a pose is set on it, each one step
 * of undo. Parts that the open character lacks complete it.
 */
export class FileOpener {
  private readonly store: Store;
  private readonly session: Session;
  /** The files of each character that was opened, so that later drops can complete it. */
  private readonly filesOf = new WeakMap<Character, readonly FileEntry[]>();

  constructor(store: Store, session: Session) {
    this.store = store;
    this.session = session;
  }

  async open(files: readonly FileEntry[]): Promise<OpenOutcome> {
    const poses = files.filter(({ path }) => extensionOf(path) === '.json');
    const parts = files.filter((file) => !poses.includes(file));
    const { characters, diagnostics } = await readCharacters(this.completed(parts));
    const problems = [...diagnostics];
    const opened = characters[0];
    const character = opened?.character ?? selectedCharacter(this.store.document.value)?.character;
    const q = character && (await readPoses(poses, character, problems));
    if (opened) {
      this.filesOf.set(opened.character, opened.files);
      this.store.dispatch(openCharacter(opened.character, methods[0]!.id, q));
      this.session.selectedJoint.value = null;
    } else if (q) this.setPose(q);
    this.session.problems.value = problems;
    return {
      character: opened?.character ?? null,
      posed: q !== undefined,
      diagnostics: problems,
    };
  }

  private setPose(q: Float64Array): void {
    const state = selectedCharacter(this.store.document.value);
    if (state) this.store.dispatch(setPose(state.id, q, 'Open a pose'));
  }

  /** The files, with those of the open character where they are just what it lacks. */
  private completed(files: readonly FileEntry[]): readonly FileEntry[] {
    const character = selectedCharacter(this.store.document.value)?.character;
    const before = character && this.filesOf.get(character);
    if (!before || files.length === 0) return files;
    const completes = files.every(({ path }) => character.missing.includes(extensionOf(path)));
    return completes ? [...before, ...files] : files;
  }
}

/** The last of the poses that can be used. */
async function readPoses(
  files: readonly FileEntry[],
  { skeleton }: Character,
  problems: Diagnostic[],
): Promise<Float64Array | undefined> {
  let q: Float64Array | undefined;
  for (const file of files) {
    const parsed = readPoseJson(file.path, decodeText(await file.bytes()), skeleton);
    problems.push(...parsed.diagnostics);
    if (parsed.value && !hasErrors(parsed.diagnostics)) q = parsed.value.q;
  }
  return q;
}
