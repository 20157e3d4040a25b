/**
 * Characters of Shift-JIS that Windows and other systems convert to different characters of Unicode
 * (JIS X 0208, and Microsoft's code page 932).
 */
const otherForms: Readonly<Record<string, string>> = {
  '\u2014': '\u2015',
  '\u2016': '\u2225',
  '\u2212': '\uff0d',
  '\u301c': '\uff5e',
  '\u00a2': '\uffe0',
  '\u00a3': '\uffe1',
  '\u00ac': '\uffe2',
};
const hasOtherForm = new RegExp(`[${Object.keys(otherForms).join('')}]`, 'g');

/**
 * The form in which names are compared: composed, because macOS gives decomposed names, in lower
 * case, and with the characters of Windows for what Shift-JIS has in two forms.
 */
export function nameKey(name: string): string {
  const composed = name.normalize('NFC').toLowerCase();
  return composed.replace(hasOtherForm, (character) => otherForms[character]!);
}

const driveOrScheme = /^(?:[a-z]:|[a-z][a-z\d+.-]*:(?=[\\/]))/i;

/**
 * The folders and the base name of a path in the form of any operating system, without drive or
 * scheme. `.` and `..` are resolved; a `..` that leads out of the path stays at its beginning.
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

/** The folders of a file, in the form in which they are compared. */
export function foldersOf(path: string): string[] {
  return segmentsOf(path).slice(0, -1).map(nameKey);
}

/** The number of equal names at the end of two lists. */
export function sharedTail(a: readonly string[], b: readonly string[]): number {
  let count = 0;
  while (count < Math.min(a.length, b.length) && a.at(-1 - count) === b.at(-1 - count)) count++;
  return count;
}

/** The number of equal names at the beginning of two lists. */
export function sharedHead(a: readonly string[], b: readonly string[]): number {
  const end = a.findIndex((name, index) => name !== b[index]);
  return end === -1 ? a.length : end;
}

/** Compares two lists of numbers by their first difference, for sorting. */
export function compareRanks(a: readonly number[], b: readonly number[]): number {
  const at = a.findIndex((value, index) => value !== b[index]);
  return at === -1 ? 0 : a[at]! - b[at]!;
}

export function comparePaths(a: string, b: string): number {
  return a < b ? -1 : a > b ? 1 : 0;
}
