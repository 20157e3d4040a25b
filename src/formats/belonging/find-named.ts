import { extensionOf, pathStem } from '../file-entry.ts';
import type { FileEntry } from '../format.ts';
import {
  comparePaths,
  compareRanks,
  nameKey,
  segmentsOf,
  sharedHead,
  sharedTail,
} from './paths.ts';

/** The file that a name in another file refers to. */
export interface Found {
  readonly file: FileEntry;
  /** Whether it is neither at the named path nor in the same folder as the file that names it. */
  readonly isGuess: boolean;
  /** Other files that fit equally well. */
  readonly others: readonly FileEntry[];
}

/** A file with its path in the form in which paths are compared. */
interface Candidate {
  readonly file: FileEntry;
  readonly folders: readonly string[];
  readonly name: string;
  /** Smaller is better; the first difference decides. */
  readonly rank: readonly number[];
}

/**
 * Finds the file that another file names. It looks for the file at the named path; then for a file
 * of that name in the same folder or in folders below; then for the nearest one, preferring paths
 * that share more of the named folders; and finally, if there is only one, for a file whose name
 * has the same beginning (`face.png` for `face.bmp`).
 *
 * @param named as the file has it: relative or absolute, in the form of any operating system
 * @param from path of the file that names it
 */
export function findNamed(
  named: string,
  from: string,
  files: readonly FileEntry[],
): Found | undefined {
  const said = segmentsOf(named);
  const wanted = said.at(-1);
  if (wanted === undefined) return undefined;
  const own = segmentsOf(from).slice(0, -1);
  const exact = segmentsOf([...own, ...said].join('/'))
    .map(nameKey)
    .join('/');
  const saidFolders = said.slice(0, -1).map(nameKey);
  const ownFolders = own.map(nameKey);

  const [best, ...others] = nearest((name) => (nameKey(name) === nameKey(wanted) ? 0 : undefined));
  if (best) {
    const [elsewhere, up, tail, down] = best.rank as [number, number, number, number];
    const isGuess = elsewhere === 1 && (up > 0 || (down > 0 && tail === 0));
    return { file: best.file, isGuess, others: others.map(({ file }) => file) };
  }
  const [alike, another] = nearest((name) => likeness(name, wanted));
  return alike && !another ? { file: alike.file, isGuess: true, others: [] } : undefined;

  /**
   * The best of the files whose names are similar, in order of path; all of them have the same
   * rank.
   */
  function nearest(unlike: (name: string) => number | undefined): Candidate[] {
    const candidates = files.flatMap((file): Candidate[] => {
      const segments = segmentsOf(file.path);
      const name = segments.at(-1) ?? '';
      const difference = unlike(name);
      return difference === undefined ? [] : [candidate(file, segments, name, difference)];
    });
    candidates.sort(
      (a, b) => compareRanks(a.rank, b.rank) || comparePaths(a.file.path, b.file.path),
    );
    return candidates.filter(({ rank }) => compareRanks(rank, candidates[0]!.rank) === 0);
  }

  function candidate(
    file: FileEntry,
    segments: readonly string[],
    name: string,
    difference: number,
  ): Candidate {
    const keys = segments.map(nameKey);
    const folders = keys.slice(0, -1);
    const shared = sharedHead(ownFolders, folders);
    const rank = [
      keys.join('/') === exact ? 0 : 1,
      ownFolders.length - shared,
      -sharedTail(saidFolders, folders),
      folders.length - shared,
      difference,
      name.normalize('NFC') === wanted!.normalize('NFC') ? 0 : 1,
    ];
    return { file, folders, name, rank };
  }
}

/**
 * 0 if the names differ only in their extension, 1 if one continues with another word, undefined
 * otherwise.
 */
function likeness(name: string, wanted: string): number | undefined {
  const [a, b] = [name, wanted].map((each) => nameKey(pathStem(each))) as [string, string];
  if (a === b) return 0;
  if (a === '' || b === '' || extensionOf(name) !== extensionOf(wanted)) return undefined;
  const [long, short] = a.length > b.length ? [a, b] : [b, a];
  return long.startsWith(short) && /^[^\p{L}]/u.test(long.slice(short.length)) ? 1 : undefined;
}
