import type { Diagnostic } from '../../core/diagnostics.ts';
import { sameValue } from '../../core/same-value.ts';
import { type Source, type SourceFile, sourceOf } from '../../document/scene.ts';
import type { FileEntry } from '../../formats/format.ts';
import type { ReadCharacter } from '../../formats/read-characters.ts';
import { withMotions } from '../bundled-motions.ts';
import { fetchBundled } from '../catalogue.ts';
import { loadBytes } from '../read-bytes.ts';
import { readFiles } from '../read-files.ts';
import type { FileFinder } from './find-files.ts';
import type { SceneParts } from './scene-parts.ts';

/** A character of a scene that was loaded, and where it came from in fact. */
export interface LoadedCharacter extends ReadCharacter {
  readonly source: Source;
}

/** What loading a character came to: the character, the files that are missing, or nothing. */
export interface LoadOutcome {
  readonly loaded?: LoadedCharacter;
  readonly missing: readonly SourceFile[];
}

const nothing: LoadOutcome = { missing: [] };

/** Loads a character, or takes it from those that the page has. */
export async function loadCharacter(
  parts: SceneParts,
  source: Source,
  finder: FileFinder,
  signal: AbortSignal,
  problems: Diagnostic[],
): Promise<LoadOutcome> {
  const open = openCharacter(parts, source);
  if (open) return { loaded: await completed(parts, open, problems), missing: [] };
  return source.kind === 'bundled'
    ? loadBundled(parts, source, signal, problems)
    : loadOwn(parts, source.files, finder, signal, problems);
}

/** The same character of the scene or of the gallery's list, so that it is in memory once. */
function openCharacter(
  { opening, opener, own }: SceneParts,
  source: Source,
): LoadedCharacter | undefined {
  if (source.kind === 'files' && source.files.length === 0) return undefined;
  const actor = opening.store.scene.peek().actors.find((each) => sameValue(each.source, source));
  const listed = own.peek().find(({ files }) => sameValue(sourceOf(files), source));
  const character = actor?.character ?? listed?.character;
  return character && { character, files: opener.filesOf(character), source };
}

async function loadBundled(
  parts: SceneParts,
  source: Source & { readonly kind: 'bundled' },
  signal: AbortSignal,
  problems: Diagnostic[],
): Promise<LoadOutcome> {
  const { entryOf, meter } = parts;
  const entry = entryOf(source.id);
  if (!entry) {
    problems.push({
      severity: 'error',
      code: 'scene/missing',
      file: 'the scene',
      expected: 'a character that comes with Sinew',
      found: source.id,
      effect: 'the character is left out',
    });
    return nothing;
  }
  const files = await fetchBundled({ files: entry.files }, signal);
  const { characters, diagnostics } = await readFiles(files, signal, meter.report);
  problems.push(...diagnostics);
  const [read] = characters;
  if (!read) return nothing;
  const loaded = { character: read.character, files: [], source };
  return { loaded: await completed(parts, loaded, problems), missing: [] };
}

/** Adds the motions that come with a bundled character, since a scene may name them. */
async function completed(
  { entryOf }: SceneParts,
  loaded: LoadedCharacter,
  problems: Diagnostic[],
): Promise<LoadedCharacter> {
  const { source, character } = loaded;
  const entry = source.kind === 'bundled' && entryOf(source.id);
  return entry ? { ...loaded, character: await withMotions(entry, character, problems) } : loaded;
}

async function loadOwn(
  { meter }: SceneParts,
  wanted: readonly SourceFile[],
  finder: FileFinder,
  signal: AbortSignal,
  problems: Diagnostic[],
): Promise<LoadOutcome> {
  const found: FileEntry[] = [];
  const missing: SourceFile[] = [];
  const pairings: Diagnostic[] = [];
  for (const each of wanted) {
    const file = await finder.find(each, pairings);
    if (file) found.push(file);
    else missing.push(each);
  }
  if (missing.length > 0) return { missing };
  const { loaded, diagnostics: unread } = await loadBytes(found);
  if (signal.aborted) return nothing;
  const { characters, diagnostics } = await readFiles(loaded, signal, meter.report);
  problems.push(...pairings, ...unread, ...diagnostics);
  // The files were those of one character.
  const read = characters.toSorted((a, b) => b.files.length - a.files.length)[0];
  if (!read) return nothing;
  return { loaded: { character: read.character, files: found, source: sourceOf(found) }, missing };
}
