import { extensionOf } from '../file-entry.ts';
import type { FileEntry, FileGroup } from '../format.ts';
import { Draft, type PartKinds } from './draft.ts';
import { findOwner } from './find-owner.ts';
import { joinAlike, joinLone } from './join-drafts.ts';

/**
 * Puts the files of each character together; no text of theirs is asked. Parts of one name are taken
 * together, those in one folder before those in the nearest ones; then parts one of whose names begins
 * with the other's (`tube.skel` and `tube_smooth.skin`); then what stands alone in a folder. Parts of
 * which there are many go to a character of their folder, then to the nearest, by the same rule. What
 * is not of one name and in one folder is a guess, and told.
 *
 * @param named files that another file names, that one first: they are together
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

/** All that a name begins with, shorter than itself. */
function beginnings(stem: string): string[] {
  return Array.from({ length: Math.max(0, stem.length - 1) }, (_, i) => stem.slice(0, i + 1));
}

function aloneWith(file: FileEntry): Draft {
  const draft = new Draft([]);
  draft.takeCompanion(file, false);
  return draft;
}
