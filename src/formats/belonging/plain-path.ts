import { segmentsOf } from './paths.ts';

/**
 * Characters that some operating system does not allow in file names. `%` might be decoded on the
 * way.
 */
const unsafe = /[\u0000-\u001f\u007f-\u009f<>:"|?*]|\p{Cf}|\p{Zl}|\p{Zp}/gu;

/** Names of devices on Windows, with any extension. */
const reserved = /^(?:con|prn|aux|nul|com\d|lpt\d)(?=\.|$)/i;

/**
 * Returns a path that is safe within an archive or a folder: with `/`, without drive, root, `.` and
 * `..`. No segment is empty, the name of a device, or a name that an operating system would change.
 * Every text has a plain path; two texts may have the same one.
 */
export function plainPath(path: string): string {
  const segments = segmentsOf(path).filter((segment) => segment !== '..');
  return segments.map(plainName).join('/') || '_';
}

/** Returns a name of one segment; `_` replaces the separators of folders. */
export function plainName(name: string): string {
  const plain = name
    .normalize('NFC')
    .replace(/[\\/]/g, '_')
    .replace(unsafe, '_')
    .replace(/^\s+|[\s.]+$/g, '')
    .replace(reserved, '_$&');
  return plain || '_';
}

/** Returns the same files with plain paths, no two of which differ only in case. */
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

/** Adds a number before the extension if the path is taken: `a (2).png`. */
function uniquePath(path: string, taken: ReadonlySet<string>): string {
  const [, stem = path, ending = ''] = /^(.*[^/])(\.[^./]*)$/u.exec(path) ?? [];
  let unique = path;
  for (let number = 2; taken.has(unique.toLowerCase()); number++) {
    unique = `${stem} (${number})${ending}`;
  }
  return unique;
}
