import { buildCharacter } from '../core/build-character.ts';
import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import { defaultLimits, type Limits } from '../core/limits.ts';
import { archiveExtension, formatExtensions } from './extensions.ts';
import { baseName, extensionOf } from './file-entry.ts';
import type { FileEntry, FileGroup, FormatReader } from './format.ts';
import { isJunk } from './junk.ts';
import { formatOf, formats } from './registry.ts';

export interface ReadCharacter {
  readonly character: Character;
  readonly files: readonly FileEntry[];
}

export interface ReadOutcome {
  readonly characters: readonly ReadCharacter[];
  readonly diagnostics: readonly Diagnostic[];
}

/** The current file, and the fraction of all bytes before it (0 to 1). */
export type ReadProgress = (label: string, fraction: number) => void;

/**
 * Loads the readers that read all of these files, so that they are there when the bytes come.
 *
 * @param names with their extensions
 */
export async function loadReaders(names: readonly string[]): Promise<void> {
  const fitting = formats.filter(({ id }) => {
    const extensions: readonly string[] = formatExtensions[id];
    return names.length > 0 && names.every((name) => extensions.includes(extensionOf(name)));
  });
  await Promise.all(fitting.map(({ loadReader }) => loadReader()));
}

/**
 * Reads all characters from any files, in any order. All callers read files through this function.
 */
export async function readCharacters(
  given: readonly FileEntry[],
  onProgress: ReadProgress = () => undefined,
  limits: Limits = defaultLimits,
): Promise<ReadOutcome> {
  const expanded = given.some(isArchive) ? await expand(given) : { files: given, diagnostics: [] };
  const characters: ReadCharacter[] = [];
  const diagnostics: Diagnostic[] = [...expanded.diagnostics];
  const files = watched(
    expanded.files.filter(({ path }) => !isJunk(path)),
    onProgress,
    diagnostics,
  );
  const used = new Set<FileEntry>();
  for (const { id, loadReader } of formats) {
    const own = files.filter((file) => formatOf(file) === id);
    if (own.length === 0) continue;
    const reader = await loadReader();
    for (const group of await reader.group(own)) {
      for (const file of group.files) used.add(file);
      const read = await readGroup(reader, group, limits, diagnostics, id);
      if (!read) continue;
      const dressed = await withImages(read, files);
      for (const file of dressed.used) used.add(file);
      diagnostics.push(...dressed.diagnostics);
      characters.push({
        character: dressed.character,
        files: [...group.files, ...dressed.used],
      });
    }
  }
  const unused = files.filter((file) => !used.has(file));
  if (characters.length > 1) diagnostics.push(...(await halves(characters)));
  if (unused.length > 0) diagnostics.push(...(await unusedFiles(unused)));
  return { characters, diagnostics };
}

/** Few users drop archives, so the first picture does not wait for this code. */
async function expand(files: readonly FileEntry[]) {
  const { expandArchives } = await loadPart(import('./zip/expand-archives.ts'));
  return expandArchives(files);
}

/** Most characters are whole, so the first picture does not wait for this code either. */
async function halves(characters: readonly ReadCharacter[]) {
  const { reportHalves } = await loadPart(import('./report-halves.ts'));
  return reportHalves(characters);
}

async function unusedFiles(files: readonly FileEntry[]) {
  const { reportUnused } = await loadPart(import('./unused-files.ts'));
  return reportUnused(files);
}

interface ReadGroup {
  readonly character: Character;
  /** The file of its mesh, whose materials name images. */
  readonly from: FileEntry;
}

/** Most characters name no images, so the first picture does not wait for this code. */
async function withImages({ character, from }: ReadGroup, files: readonly FileEntry[]) {
  const named = character.materials.some(({ texture }) => texture !== undefined);
  if (!named && character.optionalImages.length === 0) {
    return { character, used: [], diagnostics: [] };
  }
  const { attachTextures } = await loadPart(import('./attach-textures.ts'));
  return attachTextures(character, from, files);
}

async function readGroup(
  reader: FormatReader,
  group: FileGroup,
  limits: Limits,
  diagnostics: Diagnostic[],
  format: string,
): Promise<ReadGroup | undefined> {
  const parsed = await reader.read(group, limits);
  diagnostics.push(...group.diagnostics, ...parsed.diagnostics);
  if (!parsed.value) return undefined;
  const built = buildCharacter(parsed.value, limits);
  diagnostics.push(...built.diagnostics);
  const meshFile = parsed.value.mesh?.file;
  const from = group.files.find(({ path }) => baseName(path) === meshFile) ?? group.files[0]!;
  if (!built.value) return undefined;
  return { character: { ...built.value, meta: { ...built.value.meta, format } }, from };
}

/**
 * Wraps the files: reading one reports progress, and reports if it gives fewer bytes than its size.
 */
function watched(
  files: readonly FileEntry[],
  onProgress: ReadProgress,
  diagnostics: Diagnostic[],
): readonly FileEntry[] {
  const total = files.reduce((sum, { size }) => sum + size, 0);
  let before = 0;
  return files.map((file) => ({
    ...file,
    bytes: async () => {
      onProgress(baseName(file.path), total > 0 ? before / total : 0);
      before += file.size;
      const bytes = await file.bytes();
      if (bytes.length < file.size) diagnostics.push(truncated(file, bytes.length));
      return bytes;
    },
  }));
}

/** A text that was cut between two lines, or within a number, may be read without errors. */
function truncated({ path, size }: FileEntry, found: number): Diagnostic {
  return {
    severity: 'warning',
    code: 'file/truncated',
    file: baseName(path),
    expected: `${size} bytes`,
    found: `${found}`,
    effect: 'what came of the file is read',
  };
}

function isArchive({ path }: FileEntry): boolean {
  return extensionOf(path) === archiveExtension;
}
