/** A name as names are compared: composed, since macOS hands out decomposed ones, and in lower case. */
export function nameKey(name: string): string {
  return name.normalize('NFC').toLowerCase();
}

const driveOrScheme = /^(?:[a-z]:|[a-z][a-z\d+.-]*:(?=[\\/]))/i;

/**
 * The folders and the base name of a path as any system writes it, without its drive or its scheme, and
 * with `.` and `..` resolved; a `..` that leads out of the path stays at its beginning.
 */
export function segmentsOf(path: string): string[] {
  const segments: string[] = [];
  for (const segment of path.replace(driveOrScheme, '').split(/[\\/]/)) {
    if (segment === '' || segment === '.') continue;
    if (segment === '..' && segments.length > 0 && segments.at(-1) !== '..') segments.pop();
    else segments.push(segment);
  }
  return segments;
}

/** The folders of a file as they are compared. */
export function foldersOf(path: string): string[] {
  return segmentsOf(path).slice(0, -1).map(nameKey);
}

/** How many names two lists end in alike. */
export function sharedTail(a: readonly string[], b: readonly string[]): number {
  let count = 0;
  while (count < Math.min(a.length, b.length) && a.at(-1 - count) === b.at(-1 - count)) count++;
  return count;
}

/** How many names two lists begin with alike. */
export function sharedHead(a: readonly string[], b: readonly string[]): number {
  const end = a.findIndex((name, index) => name !== b[index]);
  return end === -1 ? a.length : end;
}

/** For a sort: the first difference of two lists of numbers. */
export function compareRanks(a: readonly number[], b: readonly number[]): number {
  const at = a.findIndex((value, index) => value !== b[index]);
  return at === -1 ? 0 : a[at]! - b[at]!;
}

export function comparePaths(a: string, b: string): number {
  return a < b ? -1 : a > b ? 1 : 0;
}
