import type { Diagnostic } from '../../core/diagnostics.ts';
import { ambiguousName } from '../belonging/ambiguous-name.ts';
import { Draft } from '../belonging/draft.ts';
import { findNamed } from '../belonging/find-named.ts';
import { groupParts } from '../belonging/group-parts.ts';
import { baseName, extensionOf } from '../file-entry.ts';
import type { FileEntry, FileGroup } from '../format.ts';
import { readRig } from './rig.ts';

const kinds = { single: ['.rig', '.skel', '.skin'], many: ['.morph', '.anim'] };

/**
 * Groups the files of each character: those that a `.rig` names, then the others by names and
 * folders.
 */
export async function groupFiles(files: readonly FileEntry[]): Promise<readonly FileGroup[]> {
  const rigs = files.filter(({ path }) => extensionOf(path) === '.rig');
  return groupParts(files, kinds, await Promise.all(rigs.map((rig) => draftOfRig(rig, files))));
}

async function draftOfRig(rig: FileEntry, files: readonly FileEntry[]): Promise<Draft> {
  const { value } = readRig(baseName(rig.path), await rig.bytes());
  const draft = new Draft([rig]);
  const names = {
    '.skel': value?.skeleton === undefined ? [] : [value.skeleton],
    '.skin': value?.skin === undefined ? [] : [value.skin],
    '.morph': value?.morphs ?? [],
  };
  for (const [kind, named] of Object.entries(names)) {
    const ofKind = files.filter(({ path }) => extensionOf(path) === kind);
    for (const name of named) {
      const found = findNamed(name, rig.path, ofKind);
      if (!found) draft.diagnostics.push(notThere(rig, name));
      else if (kind === '.morph') draft.takeCompanion(found.file, found.isGuess);
      else draft.take(new Draft([found.file]), found.isGuess);
      if (found) draft.diagnostics.push(...ambiguousName(rig, name, found));
    }
  }
  return draft;
}

function notThere(rig: FileEntry, name: string): Diagnostic {
  return {
    severity: 'warning',
    code: 'rig/missing',
    file: baseName(rig.path),
    expected: `"${name}" among the files`,
    found: 'none of this name',
    effect: 'the character is shown without it',
  };
}
