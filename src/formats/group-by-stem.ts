import { type Diagnostic, printable } from '../core/diagnostics.ts';
import { baseName, extensionOf, pathStem } from './file-entry.ts';
import type { FileEntry, FileGroup } from './format.ts';

/**
 * Groups files that differ only in their ending, case aside: one character each, at most one file of
 * a kind. Where that leaves one lone file of each of several kinds, they are taken together.
 */
export function groupByStem(files: readonly FileEntry[], kinds: readonly string[]): FileGroup[] {
  const groups = new Map<string, FileEntry[]>();
  for (const file of files) {
    const stem = pathStem(file.path).toLowerCase();
    groups.set(stem, [...(groups.get(stem) ?? []), file]);
  }
  const all = [...groups.values()];
  const kindsSeen = files.map(({ path }) => extensionOf(path));
  if (all.length > 1 && new Set(kindsSeen).size === files.length)
    return [joinedGroup(files, kinds)];
  return all.map((group) => onePerKind(group, kinds));
}

/** By the first kind that is there, whatever order the files come in. */
function nameOf(files: readonly FileEntry[], kinds: readonly string[]): string {
  return baseName(pathStem(sortedByKind(files, kinds)[0]!.path));
}

function sortedByKind(files: readonly FileEntry[], kinds: readonly string[]): FileEntry[] {
  const rank = ({ path }: FileEntry): number => kinds.indexOf(extensionOf(path));
  return files.toSorted((a, b) => rank(a) - rank(b));
}

function joinedGroup(files: readonly FileEntry[], kinds: readonly string[]): FileGroup {
  const names = sortedByKind(files, kinds).map(({ path }) => baseName(path));
  const joined: Diagnostic = {
    severity: 'warning',
    code: 'file/pairing',
    file: names[0]!,
    expected: 'files of one name',
    found: names.slice(1).join(', '),
    effect: `${names.map((name) => printable(name)).join(' and ')} are read as one character`,
  };
  return { name: nameOf(files, kinds), files, diagnostics: [joined] };
}

/** Two files of one name and kind differ in case alone; the first is taken. */
function onePerKind(files: readonly FileEntry[], kinds: readonly string[]): FileGroup {
  const byKind = kinds.map((kind) => files.filter(({ path }) => extensionOf(path) === kind));
  const diagnostics = byKind
    .flatMap((same) => same.slice(1))
    .map(({ path }): Diagnostic => {
      const expected = 'one file of each kind for a character';
      const effect = 'the file is not used';
      return {
        severity: 'warning',
        code: 'file/pairing',
        file: path,
        expected,
        found: baseName(path),
        effect,
      };
    });
  return { name: nameOf(files, kinds), files, diagnostics };
}
