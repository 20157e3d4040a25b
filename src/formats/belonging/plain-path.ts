import { segmentsOf } from './paths.ts';

/** What no system, or not every one, takes in the name of a file; `%` might be decoded on the way. */
const unsafe = /[\u0000-\u001f\u007f-\u009f<>:"|?*]|\p{Cf}|\p{Zl}|\p{Zp}/gu;

/** Names of devices on Windows, whatever their ending. */
const reserved = /^(?:con|prn|aux|nul|com\d|lpt\d)(?=\.|$)/i;

/**
 * The path as one within an archive or a folder of ours: with `/`, without drive, root, `.` and `..`, no
 * segment being empty, a device's name, or one that a system would change. Any text has one; two texts may
 * have the same.
 */
export function plainPath(path: string): string {
  const segments = segmentsOf(path).filter((segment) => segment !== '..');
  return segments.map(plainName).join('/') || '_';
}

/** A name of one segment: what would be folders is joined by `_`. */
export function plainName(name: string): string {
  const plain = name
    .normalize('NFC')
    .replace(/[\\/]/g, '_')
    .replace(unsafe, '_')
    .replace(/^\s+|[\s.]+$/g, '')
    .replace(reserved, '_$&');
  return plain || '_';
}

/** The same files under plain paths, no two of which differ in case alone. */
export function withPlainPaths<File extends { readonly path: string }>(
  files: readonly File[],
): File[] {
  const taken = new Set<string>();
  return files.map((file) => {
    const path = uniquePath(plainPath(file.path), taken);
    taken.add(path.toLowerCase());
    return { ...file, path };
  });
}

/** With a number before the ending where the path is taken: `a (2).png`. */
function uniquePath(path: string, taken: ReadonlySet<string>): string {
  const [, stem = path, ending = ''] = /^(.*[^/])(\.[^./]*)$/u.exec(path) ?? [];
  let unique = path;
  for (let number = 2; taken.has(unique.toLowerCase()); number++) {
    unique = `${stem} (${number})${ending}`;
  }
  return unique;
}
