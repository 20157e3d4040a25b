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

/** The file that a name in another file means. */
export interface Found {
  readonly file: FileEntry;
  /** Whether it is neither where the name says nor beside the file that names it. */
  readonly isGuess: boolean;
  /** Others that are meant just as well. */
  readonly others: readonly FileEntry[];
}

/** A file with its path as it is compared. */
interface Candidate {
  readonly file: FileEntry;
  readonly folders: readonly string[];
  readonly name: string;
  /** The smaller, the better; the first difference decides. */
  readonly rank: readonly number[];
}

/**
 * Finds the file that another one names: the one at the path that it says; else the one of that name in
 * the own folder or in folders below; else the nearest one, where more of the folders that it says agree;
 * else, as long as there is only one such, a file whose name begins alike (`face.png` for `face.bmp`).
 *
 * @param named as the file has it: relative or absolute, of any system
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

  /** The best of the files that are like the name, first by path; their ranks are the same. */
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

/** 0 where names differ in their ending alone, 1 where one goes on with another word, else nothing. */
function likeness(name: string, wanted: string): number | undefined {
  const [a, b] = [name, wanted].map((each) => nameKey(pathStem(each))) as [string, string];
  if (a === b) return 0;
  if (a === '' || b === '' || extensionOf(name) !== extensionOf(wanted)) return undefined;
  const [long, short] = a.length > b.length ? [a, b] : [b, a];
  return long.startsWith(short) && /^[^\p{L}]/u.test(long.slice(short.length)) ? 1 : undefined;
}
