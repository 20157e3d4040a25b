import type { Diagnostic } from '../../core/diagnostics.ts';
import { alikePairs, type Pair } from './alike-pairs.ts';
import { ambiguity } from './ambiguity.ts';
import type { Draft } from './draft.ts';
import { grouped } from './grouped.ts';
import { compareRanks } from './paths.ts';

/**
 * Joins drafts with similar names, from the innermost folder outwards, so that the nearest ones are
 * joined first.
 *
 * @param namesLike returns the names that are similar to a name
 */
export function joinAlike(
  drafts: readonly Draft[],
  namesLike: (stem: string) => readonly string[],
): readonly Draft[] {
  for (const members of membersByFolder(drafts)) {
    const pairs = alikePairs(current(members), namesLike);
    const pairsWith = grouped(
      pairs.flatMap((pair) => [[pair.a, pair] as const, [pair.b, pair] as const]),
    );
    for (const pair of pairs) {
      const [owner, other] = [pair.a.current, pair.b.current];
      if (!owner.fits(other)) continue;
      owner.diagnostics.push(
        ...ambiguous(pair.a, pair.b, pair, pairsWith.get(pair.a)!),
        ...ambiguous(pair.b, pair.a, pair, pairsWith.get(pair.b)!),
      );
      const isOneName = owner.stems.some((stem) => other.stems.includes(stem));
      owner.take(other, !(isOneName && owner.sharesFolder(other)));
    }
  }
  return current(drafts);
}

/** Joins the drafts of a folder and its subfolders if all of them can be one character. */
export function joinLone(drafts: readonly Draft[]): readonly Draft[] {
  for (const members of membersByFolder(drafts)) {
    const all = current(members);
    if (!all.every((a, index) => all.slice(index + 1).every((b) => a.fits(b)))) continue;
    for (const other of all.slice(1)) all[0]!.take(other, true);
  }
  return current(drafts);
}

/** For each folder, the innermost first, the drafts with a file in it or below it. */
function membersByFolder(drafts: readonly Draft[]): readonly (readonly Draft[])[] {
  const members = grouped(
    drafts.flatMap((draft) =>
      draft.folders.flatMap((folders) =>
        [...folders.keys(), folders.length].map(
          (depth) =>
            [
              folders
                .slice(0, depth)
                .map((each) => `${each}/`)
                .join(''),
              draft,
            ] as const,
        ),
      ),
    ),
  );
  const depthOf = (folder: string): number => folder.split('/').length;
  return [...members].sort(([a], [b]) => depthOf(b) - depthOf(a)).map(([, each]) => each);
}

/** The drafts that have the files of these drafts now, without duplicates. */
function current(drafts: readonly Draft[]): Draft[] {
  return [...new Set(drafts.map((draft) => draft.current))];
}

/** Reports that a draft fits others as well as the one to which it is joined. */
function ambiguous(
  kept: Draft,
  chosen: Draft,
  { rank }: Pair,
  pairs: readonly Pair[],
): Diagnostic[] {
  const rivals = pairs
    .filter((pair) => compareRanks(pair.rank, rank) === 0)
    .map(({ a, b }) => (a === kept ? b : a).current)
    .filter((rival) => rival !== chosen.current && rival.fits(kept.current))
    .filter((rival) => !rival.fits(chosen.current));
  const path = chosen.firstPath;
  const paths = rivals.map(({ firstPath }) => firstPath);
  const expected = `one file that is nearest to it, as ${path}`;
  return ambiguity(kept.firstPath, paths, { expected, effect: `it is read with ${path}` });
}
