import type { Diagnostic } from '../../core/diagnostics.ts';
import { baseName, extensionOf, pathStem } from '../file-entry.ts';
import type { FileEntry, FileGroup } from '../format.ts';
import { groupByStem } from '../group-by-stem.ts';
import { readRig } from './rig.ts';

const bodyKinds = ['.skel', '.skin'];

/** A group while files are still added to it. */
interface Draft {
  readonly name: string;
  readonly files: FileEntry[];
  readonly diagnostics: Diagnostic[];
}

/**
 * Puts the files of a character together: those that a `.rig` names; `.skel` and `.skin` of one name;
 * then each `.morph` and `.anim` with the character whose name its own begins with (`head1.morph` with
 * `head.skin`), or with the only one that there is.
 */
export function groupFiles(files: readonly FileEntry[]): FileGroup[] {
  const rigged = files.filter(isRig).map((rig) => groupOfRig(rig, files));
  const taken = new Set(rigged.flatMap(({ files: own }) => own));
  const rest = files.filter((file) => !taken.has(file));
  const bodies = groupByStem(
    rest.filter(({ path }) => bodyKinds.includes(extensionOf(path))),
    bodyKinds,
  ).map((group) => ({ ...group, files: [...group.files], diagnostics: [...group.diagnostics] }));
  const groups: Draft[] = [...rigged, ...bodies];
  for (const file of rest) {
    if (bodyKinds.includes(extensionOf(file.path))) continue;
    const owner = ownerOf(file, groups);
    if (owner) owner.files.push(file);
    else groups.push({ name: baseName(pathStem(file.path)), files: [file], diagnostics: [] });
  }
  return groups;
}

function isRig({ path }: FileEntry): boolean {
  return extensionOf(path) === '.rig';
}

/** What a rig names is looked for by base name, case aside, in any folder. */
function groupOfRig(rig: FileEntry, files: readonly FileEntry[]): Draft {
  const name = baseName(pathStem(rig.path));
  const { value } = readRig(baseName(rig.path), rig.head);
  const named = [value?.skeleton, value?.skin, ...(value?.morphs ?? [])].filter(
    (each) => each !== undefined,
  );
  const diagnostics: Diagnostic[] = [];
  const found = named.map((each) => {
    const file = files.find(({ path }) => sameName(path, each));
    if (!file) diagnostics.push(notThere(rig, each));
    return file;
  });
  return { name, files: [...new Set([rig, ...found.filter((file) => !!file)])], diagnostics };
}

function sameName(path: string, name: string): boolean {
  return baseName(path).toLowerCase() === baseName(name).toLowerCase();
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

/** The group with the longest name that the file's begins with; else the only one with a body. */
function ownerOf(file: FileEntry, groups: readonly Draft[]): Draft | undefined {
  const stem = baseName(pathStem(file.path)).toLowerCase();
  const withBody = groups.filter(({ files }) =>
    files.some(({ path }) => bodyKinds.includes(extensionOf(path))),
  );
  let best: Draft | undefined;
  let longest = 0;
  for (const group of withBody) {
    for (const { path } of group.files) {
      const own = baseName(pathStem(path)).toLowerCase();
      if (own.length <= longest || !stem.startsWith(own)) continue;
      if (!bodyKinds.includes(extensionOf(path))) continue;
      [best, longest] = [group, own.length];
    }
  }
  if (best || withBody.length !== 1) return best;
  const [only] = withBody;
  only!.diagnostics.push({
    severity: 'warning',
    code: 'file/pairing',
    file: baseName(file.path),
    expected: `a name that begins with "${only!.name}"`,
    found: baseName(file.path),
    effect: `it is read with ${only!.name}, the only character here`,
  });
  return only;
}
