import type { Diagnostic } from '../core/diagnostics.ts';
import { defaultLimits } from '../core/limits.ts';
import { readableExtensions } from '../formats/extensions.ts';
import { extensionOf } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { readFault } from '../ui/file-entry.ts';
import type { LooseFile } from '../workers/read-characters-task.ts';

/** Loads the bytes of all files that can be read. Problems are reported, not thrown. */
export async function loadBytes(
  files: readonly FileEntry[],
): Promise<{ loaded: LooseFile[]; diagnostics: Diagnostic[] }> {
  const loaded: LooseFile[] = [];
  const diagnostics: Diagnostic[] = [];
  for (const file of files) {
    const { path, fault } = file;
    const isRead = fault !== undefined || readableExtensions.includes(extensionOf(path));
    // Files that Sinew does not read only appear in the list of unused files.
    const bytes = isRead ? await readBytes(file, diagnostics) : new Uint8Array(0);
    if (bytes) loaded.push({ path, bytes });
  }
  return { loaded, diagnostics };
}

/**
 * Returns the bytes of a file. If it is too large or can't be read, it returns nothing and adds a
 * problem.
 */
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
    // The file was moved, deleted or changed after the drop.
    fail(unreadable, 'a file that can be read', readFault(error));
    return undefined;
  }
}
