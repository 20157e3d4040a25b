import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import { openCharacter, setPose } from '../document/commands.ts';
import {
  type CharacterState,
  type KeptState,
  selectedCharacter,
  type Source,
} from '../document/document.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import { baseName, extensionOf } from '../formats/file-entry.ts';
import { companionExtensions, textureExtensions } from '../formats/extensions.ts';
import type { FileEntry } from '../formats/format.ts';
import type { ReadCharacter, ReadProgress } from '../formats/read-characters.ts';
import { defaultMethod } from '../skinning/registry.ts';
import type { MethodId } from '../skinning/method.ts';
import { readFiles } from './read-files.ts';
import { readPoses, sortFiles } from './sort-files.ts';

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
   * @param source a bundled character neither completes nor renews what is open
   * @returns nothing where it was aborted; the page is then as it was
   */
  async open(
    files: readonly FileEntry[],
    signal: AbortSignal,
    onProgress: ReadProgress,
    openBundled: (id: string) => Promise<void>,
    source: Source,
  ): Promise<OpenOutcome | undefined> {
    const fresh = source.kind === 'bundled';
    const { poses, notes, parts } = await sortFiles(files);
    const completed = fresh ? parts : this.completed(parts);
    const onlyPictures = completed.every(isPicture);
    const { characters, diagnostics } = onlyPictures
      ? { characters: [], diagnostics: completed.map(plainPicture) }
      : await readFiles(completed, signal, onProgress);
    if (signal.aborted) return undefined;
    const problems = [...diagnostics];
    const first = characters[0];
    const remembered = notes.at(-1)?.bundled;
    if (!first && remembered !== undefined) await openBundled(remembered);
    const renewed = first && !fresh && this.renews(first) ? this.selected : undefined;
    const character = first?.character ?? this.selected?.character;
    const q = character && readPoses({ poses, notes }, character, problems);
    if (first) {
      this.show(first, source, q, renewed);
      problems.push(...missingParts(first.character));
    } else if (q && this.selected) {
      this.store.dispatch(setPose(this.selected.id, q, 'Open a pose'));
    }
    this.session.problems.value = problems;
    return {
      found: characters,
      opened: first?.character ?? null,
      reopened: renewed !== undefined,
      posed: q !== undefined,
    };
  }

  /**
   * Opens a character that was read, at the given pose or the file's.
   *
   * @param before the open one, of the same files: its pose, shape and clip go on, and it plays on
   */
  show(read: ReadCharacter, source: Source, q?: Float64Array, before?: CharacterState): void {
    const { character } = read;
    const kept = {
      source,
      ...(before && keptState(before, character)),
      ...(q && { q, clip: null }),
    };
    this.filesOf.set(character, read.files);
    this.store.dispatch(openCharacter(character, this.methodFor(character), kept));
    if (!before || before.character.clips.length === 0) {
      this.session.clipIndex.value = 0;
      this.session.clipTime.value = character.clips[0]?.start ?? 0;
    }
    if (before) return;
    this.session.selectedJoint.value = null;
    this.session.hoveredJoint.value = null;
    this.session.hoveredBone.value = null;
    this.session.hoverPlace.value = null;
    this.session.activeDof.value = null;
  }

  private get selected(): CharacterState | undefined {
    return selectedCharacter(this.store.document.value);
  }

  /** The character's own method, unless the user chose another for the one before. */
  private methodFor(character: Character): MethodId {
    const before = this.selected;
    const chosen = before && before.method !== defaultMethod(before.character).id;
    return chosen ? before.method : defaultMethod(character).id;
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
    const missing = character.missing.map((what) => what.toLowerCase());
    const belong = files.every(
      (file) =>
        [...missing, ...companionExtensions].includes(extensionOf(file.path)) ||
        [...missing, ...oldNames].includes(nameOf(file)),
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

/** What the character that is open hands on to the one that its files, read again, make. */
function keptState(before: CharacterState, character: Character): KeptState {
  const { q, morphWeights, normalizeWeights, clip } = before;
  const { morphs, clips } = before.character;
  const weights = new Map(morphs.map(({ name }, index) => [name, morphWeights[index]!]));
  const bound = character.clips.findIndex(({ name }) => name === clips[clip ?? -1]?.name);
  return {
    q,
    morphWeights: Float64Array.from(character.morphs, ({ name }) => weights.get(name) ?? 0),
    clip: bound === -1 ? null : bound,
    normalizeWeights,
  };
}

/** What the character's files leave out, with the way to add it. */
function missingParts({ name, missing }: Character): Diagnostic[] {
  return missing.map((what) => ({
    severity: 'warning',
    code: 'file/missing',
    file: name,
    expected: what.startsWith('.') ? `${name}${what}` : what,
    found: 'no such file',
    effect: 'the rest is shown; drop the file here to complete the character',
  }));
}

function plainPicture({ path }: FileEntry): Diagnostic {
  return {
    severity: 'warning',
    code: 'file/unknown',
    file: path,
    expected: 'a PNG that Sinew saved, or a picture that a material of the open character names',
    found: 'another picture',
    effect: 'the file is not used',
  };
}

function isPicture({ path }: FileEntry): boolean {
  return textureExtensions.includes(extensionOf(path));
}
