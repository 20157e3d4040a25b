import type { FileEntry } from '../format.ts';
import { ambiguity } from './ambiguity.ts';
import { type Draft, stemOf } from './draft.ts';
import { comparePaths, compareRanks, foldersOf, sharedHead } from './paths.ts';

/** The character to which a file belongs, if characters may have many files of its kind. */
interface Owner {
  readonly owner: Draft;
  readonly isGuess: boolean;
}

/**
 * Finds the character with whose name the file's name begins, in the file's folder, or else the
 * only character in that folder. Then searches the folders around it in the same way. The longest
 * name wins, then the nearest file.
 */
export function findOwner(file: FileEntry, drafts: readonly Draft[]): Owner | undefined {
  const own = foldersOf(file.path);
  const beside = drafts.filter(({ folders }) =>
    folders.some((each) => each.join('/') === own.join('/')),
  );
  const named = begun(file, own, beside);
  if (named) return { owner: named, isGuess: false };
  if (beside.length === 1) return { owner: beside[0]!, isGuess: true };
  const [byName, alone] = [begunOutward(), aloneOutward()];
  const owner = byName ?? alone;
  return owner && { owner, isGuess: true };

  function begunOutward(): Draft | undefined {
    for (let depth = own.length; depth >= 0; depth--) {
      const found = begun(file, own, within(depth));
      if (found) return found;
    }
    return undefined;
  }

  function aloneOutward(): Draft | undefined {
    for (let depth = own.length; depth >= 0; depth--) {
      const [first, another] = within(depth);
      if (first) return another ? undefined : first;
    }
    return undefined;
  }

  /** The drafts with a part in the folder at this depth from the root, or below it. */
  function within(depth: number): Draft[] {
    return drafts.filter(({ folders }) => folders.some((each) => sharedHead(own, each) >= depth));
  }
}

/**
 * Of the drafts with whose name the file's name begins, the one with the longest name; of several,
 * the nearest, or else the first.
 */
function begun(
  file: FileEntry,
  own: readonly string[],
  drafts: readonly Draft[],
): Draft | undefined {
  const stem = stemOf(file.path);
  const candidates = drafts.flatMap((draft) => {
    const lengths = draft.stems.filter((each) => stem.startsWith(each)).map(({ length }) => length);
    if (lengths.length === 0) return [];
    const down = Math.min(...draft.folders.map((each) => each.length - sharedHead(own, each)));
    return [{ draft, rank: [-Math.max(...lengths), -draft.sharedTail([[...own]]), down] }];
  });
  candidates.sort(
    (a, b) => compareRanks(a.rank, b.rank) || comparePaths(a.draft.firstPath, b.draft.firstPath),
  );
  const [best, ...others] = candidates;
  const rivals = others.filter(({ rank }) => compareRanks(rank, best!.rank) === 0);
  if (!best) return undefined;
  const taken = best.draft.firstPath;
  const paths = rivals.map(({ draft }) => draft.firstPath);
  const expected = `one character that is nearest to it, as that of ${taken}`;
  const effect = `it is read with ${taken}`;
  best.draft.diagnostics.push(...ambiguity(file.path, paths, { expected, effect }));
  return best.draft;
}
