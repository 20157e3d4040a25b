import type { Diagnostic } from '../../core/diagnostics.ts';
import { ambiguousName } from '../belonging/ambiguous-name.ts';
import { Draft } from '../belonging/draft.ts';
import { findNamed } from '../belonging/find-named.ts';
import { groupParts } from '../belonging/group-parts.ts';
import { baseName, extensionOf } from '../file-entry.ts';
import type { FileEntry, FileGroup } from '../format.ts';
import { headTokens } from '../text/head-tokens.ts';
import { libraryExtension, partKinds } from './kinds.ts';

/**
 * Groups the files of each character by names and folders, after each `.obj` has taken the material
 * libraries that it names.
 */
export function groupWithLibraries(files: readonly FileEntry[]): readonly FileGroup[] {
  const libraries = files.filter(({ path }) => extensionOf(path) === libraryExtension);
  const drafts = files
    .filter(({ path }) => extensionOf(path) === '.obj')
    .map((mesh) => draftOfMesh(mesh, libraries));
  return groupParts(files, partKinds, drafts);
}

function draftOfMesh(mesh: FileEntry, libraries: readonly FileEntry[]): Draft {
  const draft = new Draft([mesh]);
  for (const name of namedLibraries(mesh)) {
    const found = findNamed(name, mesh.path, libraries);
    if (found) {
      draft.takeCompanion(found.file, found.isGuess);
      draft.diagnostics.push(...ambiguousName(mesh, name, found));
    } else draft.diagnostics.push(notThere(mesh, name));
  }
  return draft;
}

/** The names after `mtllib` at the beginning of the file, where programs write it. */
function namedLibraries({ head }: FileEntry): string[] {
  const lines = headTokens(head).matchAll(/^[^\S\r\n]*mtllib[^\S\r\n]+(\S.*?)\s*$/gm);
  return Array.from(lines, ([, names]) => namesOf(names!)).flat();
}

/** A line may have several names, and a name may have blanks. */
function namesOf(line: string): string[] {
  return line.match(/\S.*?\.mtl(?=\s|$)/gi) ?? [line];
}

function notThere(mesh: FileEntry, name: string): Diagnostic {
  return {
    severity: 'warning',
    code: 'obj/missing',
    file: baseName(mesh.path),
    expected: `"${name}" among the files`,
    found: 'none of this name',
    effect: 'its materials are plain',
  };
}
