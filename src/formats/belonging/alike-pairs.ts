import type { Draft } from './draft.ts';
import { grouped } from './grouped.ts';
import { comparePaths, compareRanks } from './paths.ts';

/** Two drafts that may belong to one character. */
export interface Pair {
  readonly a: Draft;
  readonly b: Draft;
  /** Smaller is better; the first difference decides. */
  readonly rank: readonly number[];
}

/**
 * Returns the pairs of drafts with similar names, the best first: by how much of the names agrees,
 * by how many of their folders have the same names, by how near they are to the root, and by path.
 *
 * @param namesLike returns the names that are similar to a name
 */
export function alikePairs(
  drafts: readonly Draft[],
  namesLike: (stem: string) => readonly string[],
): readonly Pair[] {
  const places = new Map(drafts.map((draft, index) => [draft, index]));
  const byStem = grouped(
    drafts.flatMap((draft) => [...new Set(draft.stems)].map((stem) => [stem, draft] as const)),
  );
  const pairs: Pair[] = [];
  for (const b of drafts) {
    for (const stem of new Set(b.stems.flatMap(namesLike))) {
      for (const a of byStem.get(stem) ?? []) {
        // A pair of equal names is found from both of its sides.
        const isMet = b.stems.includes(stem) && places.get(a)! > places.get(b)!;
        if (isMet || !a.fits(b)) continue;
        const depth = Math.min(...[...a.folders, ...b.folders].map(({ length }) => length));
        pairs.push({ a, b, rank: [-stem.length, -a.sharedTail(b.folders), depth] });
      }
    }
  }
  return pairs.sort(
    (x, y) =>
      compareRanks(x.rank, y.rank) ||
      comparePaths(x.a.firstPath, y.a.firstPath) ||
      comparePaths(x.b.firstPath, y.b.firstPath),
  );
}
