import { type Diagnostic, DiagnosticLog } from '../../core/diagnostics.ts';
import { archiveExtension, readableExtensions } from '../extensions.ts';
import { baseName, extensionOf, memoryFile } from '../file-entry.ts';
import type { FileEntry } from '../format.ts';
import { isJunk } from '../junk.ts';
import { unpack } from './unpack.ts';
import { readDirectory, type ZipEntry } from './directory.ts';

/** Bounds on what an archive may unfold to; a few kilobytes can claim to be terabytes. */
export interface ArchiveLimits {
  readonly entryCount: number;
  readonly totalSize: number;
  /** Unpacked over packed size of one file, where it is larger than `freeSize`. */
  readonly ratio: number;
  /** Weights of zeros and ones pack very well, and what is as small does no harm. */
  readonly freeSize: number;
}

export const defaultArchiveLimits: ArchiveLimits = {
  entryCount: 10_000,
  totalSize: 512 * 1024 * 1024,
  ratio: 200,
  freeSize: 16 * 1024 * 1024,
};

/**
 * The files, with those of zip archives in folders of the archives' names. Archives within archives are
 * not opened; files that no reader asks for are listed, not unpacked.
 */
export async function expandArchives(
  files: readonly FileEntry[],
  limits: ArchiveLimits = defaultArchiveLimits,
): Promise<{ files: readonly FileEntry[]; diagnostics: readonly Diagnostic[] }> {
  const diagnostics: Diagnostic[] = [];
  const expanded: FileEntry[] = [];
  for (const file of files) {
    if (extensionOf(file.path) !== archiveExtension) expanded.push(file);
    else {
      const log = new DiagnosticLog(baseName(file.path));
      const unpacked = expandArchive(await file.bytes(), limits, log);
      expanded.push(...unpacked.map((each) => ({ ...each, path: `${file.path}/${each.path}` })));
      diagnostics.push(...log.diagnostics);
    }
  }
  return { files: expanded, diagnostics };
}

function expandArchive(bytes: Uint8Array, limits: ArchiveLimits, log: DiagnosticLog): FileEntry[] {
  const entries = readDirectory(bytes);
  if (typeof entries === 'string') return refuse('archive', 'a zip archive', entries);
  const files = entries.filter(({ name }) => !name.endsWith('/') && !isJunk(name));
  const excess = excessOf(entries.length, files.filter(isRead), limits);
  if (excess !== undefined) return refuse('limit', 'an archive of usual size', excess);
  const unpacked: FileEntry[] = [];
  for (const entry of files) {
    if (extensionOf(entry.name) === archiveExtension) reportNested(entry.name, log);
    else if (!isRead(entry)) unpacked.push(memoryFile(entry.name, new Uint8Array(0)));
    else {
      const content = unpack(entry);
      if (typeof content === 'string')
        return refuse('archive', 'files that can be unpacked', content);
      unpacked.push(memoryFile(entry.name, content));
    }
  }
  return unpacked;

  function refuse(kind: 'archive' | 'limit', expected: string, found: string): FileEntry[] {
    log.error({ code: `file/${kind}`, expected, found, effect: 'the archive is not used' });
    return [];
  }
}

function isRead({ name }: ZipEntry): boolean {
  const extension = extensionOf(name);
  return extension !== archiveExtension && readableExtensions.includes(extension);
}

/** What there is too much of, by what the directory says; unpacking holds it to that. */
function excessOf(
  entryCount: number,
  files: readonly ZipEntry[],
  limits: ArchiveLimits,
): string | undefined {
  if (entryCount > limits.entryCount) return `more than ${limits.entryCount} files`;
  const totalSize = files.reduce((sum, { size }) => sum + size, 0);
  if (totalSize > limits.totalSize) return `more than ${limits.totalSize} bytes in all`;
  const bomb = files.find(
    ({ size, packed }) => size > limits.freeSize && size > limits.ratio * packed.length,
  );
  return bomb && `"${bomb.name}", ${bomb.size} bytes from ${bomb.packed.length}`;
}

function reportNested(name: string, log: DiagnosticLog): void {
  log.warn({
    code: 'file/archive',
    expected: 'files in the archive',
    found: name,
    effect: 'an archive within an archive is not opened',
  });
}
