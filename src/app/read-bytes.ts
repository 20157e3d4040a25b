import type { Diagnostic } from '../core/diagnostics.ts';
import { defaultLimits } from '../core/limits.ts';
import type { FileEntry } from '../formats/format.ts';
import { readFault } from '../ui/file-entry.ts';

/** The bytes of a file; nothing where it is too large or can't be read, which is added to the problems. */
export async function readBytes(
  file: FileEntry,
  problems: Diagnostic[],
): Promise<Uint8Array | undefined> {
  const { path, size } = file;
  const fail = (code: Diagnostic['code'], expected: string, found: string): void => {
    const effect = 'what is in it is not used';
    problems.push({ severity: 'error', code, file: path, expected, found, effect });
  };
  if (size > defaultLimits.fileSize) {
    fail('file/limit', `at most ${defaultLimits.fileSize} bytes`, `${size}`);
    return undefined;
  }
  const unreadable = 'file/unreadable';
  if (file.fault !== undefined) {
    fail(unreadable, 'a file or folder that can be read', file.fault);
    return undefined;
  }
  try {
    return await file.bytes();
  } catch (error) {
    // Moved, deleted or changed between the drop and now.
    fail(unreadable, 'a file that can be read', readFault(error));
    return undefined;
  }
}
