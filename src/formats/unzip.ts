import { type Diagnostic, DiagnosticLog } from '../core/diagnostics.ts';
import { baseName, extensionOf, memoryFile } from './file-entry.ts';
import type { FileEntry } from './format.ts';

/** Bounds on what an archive may unfold to; a few kilobytes can claim to be terabytes. */
export interface ArchiveLimits {
  readonly entryCount: number;
  readonly totalSize: number;
  /** Unpacked over packed size of one entry. */
  readonly ratio: number;
}

export const defaultArchiveLimits: ArchiveLimits = {
  entryCount: 10_000,
  totalSize: 512 * 1024 * 1024,
  ratio: 200,
};

const effect = 'the archive is not used';

/** The files, with those of zip archives in the place of the archives; archives are not nested. */
export async function expandArchives(
  files: readonly FileEntry[],
  limits: ArchiveLimits = defaultArchiveLimits,
): Promise<{ files: readonly FileEntry[]; diagnostics: readonly Diagnostic[] }> {
  const diagnostics: Diagnostic[] = [];
  const expanded: FileEntry[] = [];
  for (const file of files) {
    if (extensionOf(file.path) !== '.zip') expanded.push(file);
    else {
      const log = new DiagnosticLog(baseName(file.path));
      expanded.push(...(await expandArchive(file, limits, log)));
      diagnostics.push(...log.diagnostics);
    }
  }
  return { files: expanded, diagnostics };
}

async function expandArchive(
  file: FileEntry,
  limits: ArchiveLimits,
  log: DiagnosticLog,
): Promise<FileEntry[]> {
  // Few users drop archives, so that the first picture does not wait for this.
  const { unzipSync } = await import('fflate');
  let entryCount = 0;
  let totalSize = 0;
  let exceeded = '';
  const allow = ({ name, size, originalSize }: ZipEntry): boolean => {
    if (name.endsWith('/') || name.endsWith('\\')) return false;
    entryCount++;
    totalSize += originalSize;
    if (entryCount > limits.entryCount) exceeded = `more than ${limits.entryCount} files`;
    else if (totalSize > limits.totalSize) exceeded = `more than ${limits.totalSize} bytes in all`;
    else if (originalSize > limits.ratio * Math.max(size, 1024))
      exceeded = `"${name}", ${originalSize} bytes from ${size}`;
    return exceeded === '';
  };
  try {
    const unpacked = unzipSync(await file.bytes(), { filter: allow });
    if (exceeded === '') {
      return Object.entries(unpacked).map(([name, bytes]) =>
        memoryFile(name.replaceAll('\\', '/'), bytes),
      );
    }
    log.error({
      code: 'file/limit',
      expected: 'an archive of usual size',
      found: exceeded,
      effect,
    });
  } catch (error) {
    const found = error instanceof Error ? error.message : 'something else';
    log.error({ code: 'file/archive', expected: 'a zip archive', found, effect });
  }
  return [];
}

interface ZipEntry {
  readonly name: string;
  readonly size: number;
  readonly originalSize: number;
}
