import { extensionOf } from '../file-entry.ts';
import type { FileEntry, FileGroup } from '../format.ts';
import { Draft, type PartKinds } from './draft.ts';
import { findOwner } from './find-owner.ts';
import { joinAlike, joinLone } from './join-drafts.ts';

/**
 * Groups the files of each character without reading their text. Files of the same name are joined
 * first: those in the same folder, then those in the nearest folders. Then files one of whose names
 * begins with the other's (`tube.skel` and `tube_smooth.skin`), then files that are alone in a
 * folder. Files of kinds of which a character may have many join a character of their folder, then
 * the nearest one, by the same rule. Anything except equal names in the same folder is a guess and
 * is reported.
 *
 * @param named lists of files that belong together because the first of each names the others
 */
export function groupParts(
  files: readonly FileEntry[],
  kinds: PartKinds,
  named: readonly Draft[] = [],
): FileGroup[] {
  const order = new Map(files.map((file, index) => [file, index]));
  const taken = new Set(named.flatMap(({ parts, companions }) => [...parts, ...companions]));
  const rest = files.filter((file) => !taken.has(file));
  const isMany = ({ path }: FileEntry): boolean => kinds.many.includes(extensionOf(path));
  const single = rest.filter((file) => !isMany(file)).map((file) => new Draft([file]));

  let drafts: readonly Draft[] = [...named, ...single];
  drafts = joinAlike(drafts, (stem) => [stem]);
  drafts = joinAlike(drafts, beginnings);
  drafts = joinLone(drafts);

  const unowned: Draft[] = [];
  for (const file of rest.filter(isMany)) {
    const found = findOwner(file, drafts);
    if (found) found.owner.takeCompanion(file, found.isGuess);
    else unowned.push(aloneWith(file));
  }
  return [...drafts, ...unowned]
    .map((draft) => draft.finish(kinds, order))
    .sort((a, b) => order.get(a.files[0]!)! - order.get(b.files[0]!)!);
}

/** All beginnings of a name that are shorter than the name. */
function beginnings(stem: string): string[] {
  return Array.from({ length: Math.max(0, stem.length - 1) }, (_, i) => stem.slice(0, i + 1));
}

function aloneWith(file: FileEntry): Draft {
  const draft = new Draft([]);
  draft.takeCompanion(file, false);
  return draft;
}
