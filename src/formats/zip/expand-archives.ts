import { type Diagnostic, DiagnosticLog } from '../../core/diagnostics.ts';
import { archiveExtension, readableExtensions } from '../extensions.ts';
import { baseName, extensionOf, memoryFile } from '../file-entry.ts';
import type { FileEntry } from '../format.ts';
import { isJunk } from '../junk.ts';
import { isLfsPointer, lfsPointer } from '../text/lfs-pointer.ts';
import { readDirectory, type ZipEntry } from './directory.ts';
import { LeftOut } from './left-out.ts';
import { recoverEntries } from './recover.ts';
import { unpack } from './unpack.ts';

const archiveUnused = 'the archive is not used';

/** Limits on the unpacked size of an archive; a few kilobytes can claim to be terabytes. */
export interface ArchiveLimits {
  readonly entryCount: number;
  readonly totalSize: number;
  /** The largest ratio of unpacked to packed size for files that are larger than `freeSize`. */
  readonly ratio: number;
  /** Weights of zeros and ones compress very well, and files up to this size do no harm. */
  readonly freeSize: number;
}

export const defaultArchiveLimits: ArchiveLimits = {
  entryCount: 10_000,
  totalSize: 512 * 1024 * 1024,
  ratio: 200,
  freeSize: 16 * 1024 * 1024,
};

/**
 * Returns the files, with those of zip archives in folders of the archives' names. Archives within
 * archives are not opened. Files that no reader uses are listed but not unpacked.
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
      const unpacked = unpackArchive(await file.bytes(), log, isRead, limits);
      expanded.push(...unpacked.map((each) => ({ ...each, path: `${file.path}/${each.path}` })));
      diagnostics.push(...log.diagnostics);
    }
  }
  return { files: expanded, diagnostics };
}

/**
 * Returns the files of an archive.
 *
 * @param isWanted whether a file is unpacked, or else only listed
 */
export function unpackArchive(
  bytes: Uint8Array,
  log: DiagnosticLog,
  isWanted: (entry: ZipEntry) => boolean,
  limits: ArchiveLimits = defaultArchiveLimits,
): FileEntry[] {
  if (isLfsPointer(bytes)) {
    log.error({ ...lfsPointer, effect: archiveUnused });
    return [];
  }
  const entries = entriesOf(bytes, log);
  if (entries.length > limits.entryCount) {
    const found = `more than ${limits.entryCount} files`;
    refuse('limit', 'an archive of usual size', found, log);
    return [];
  }
  const isFolder = folderTest(entries);
  const files = lastOfEachName(
    entries.filter((entry) => !isFolder(entry) && !isJunk(entry.name)),
    log,
  );
  const leftOut = new LeftOut();
  const unpacked: FileEntry[] = [];
  let totalSize = 0;
  for (const entry of files) {
    if (extensionOf(entry.name) === archiveExtension) reportNested(entry.name, log);
    else if (!isWanted(entry)) unpacked.push(memoryFile(entry.name, new Uint8Array(0)));
    else {
      const content = excessOf(entry, totalSize, limits) ?? unpack(entry);
      if (typeof content === 'string') leftOut.add(entry.name, content);
      else {
        totalSize += content.length;
        unpacked.push(memoryFile(entry.name, content));
      }
    }
  }
  leftOut.report(log);
  return unpacked;
}

/** Some programs write folders without a slash at the end, which are told by what is in them. */
function folderTest(entries: readonly ZipEntry[]): (entry: ZipEntry) => boolean {
  const parents = new Set(entries.map(({ name }) => name.slice(0, name.lastIndexOf('/'))));
  return ({ name, isFolder, size }) =>
    isFolder || name.endsWith('/') || (size === 0 && parents.has(name));
}

/** Reads the archive's directory or, if it is missing, the files' own headers, with a warning. */
function entriesOf(bytes: Uint8Array, log: DiagnosticLog): readonly ZipEntry[] {
  const entries = readDirectory(bytes);
  if (typeof entries !== 'string') return entries;
  const recovered = recoverEntries(bytes);
  if (recovered.length === 0) refuse('archive', 'a zip archive', entries, log);
  else {
    log.errorOfPart({
      code: 'file/archive',
      expected: 'a whole zip archive',
      found: entries,
      effect: `what is left of it is read: ${recovered.length === 1 ? 'one file' : `${recovered.length} files`}`,
    });
  }
  return recovered;
}

function refuse(
  kind: 'archive' | 'limit',
  expected: string,
  found: string,
  log: DiagnosticLog,
): void {
  log.error({ code: `file/${kind}`, expected, found, effect: archiveUnused });
}

/** The last file of a name counts, because programs that unpack overwrite the earlier ones. */
function lastOfEachName(entries: readonly ZipEntry[], log: DiagnosticLog): ZipEntry[] {
  const byName = new Map(entries.map((entry) => [entry.name, entry]));
  const twice = entries.find((entry) => byName.get(entry.name) !== entry);
  if (twice) {
    log.warn({
      code: 'file/duplicate',
      expected: 'each name once',
      found: `${entries.length - byName.size} again, as "${twice.name}"`,
      effect: 'the last of each counts',
    });
  }
  return [...byName.values()];
}

function isRead({ name }: ZipEntry): boolean {
  const extension = extensionOf(name);
  return extension !== archiveExtension && readableExtensions.includes(extension);
}

/** Returns why a file is too large, by the size in the directory; unpacking enforces that size. */
function excessOf(
  { size, packed }: ZipEntry,
  totalSize: number,
  limits: ArchiveLimits,
): string | undefined {
  if (totalSize + size > limits.totalSize) return `past ${limits.totalSize} bytes in all`;
  const isBomb = packed && size > limits.freeSize && size > limits.ratio * packed.length;
  return isBomb ? `too large, ${size} bytes from ${packed.length}` : undefined;
}

function reportNested(name: string, log: DiagnosticLog): void {
  log.warn({
    code: 'file/archive',
    expected: 'files in the archive',
    found: name,
    effect: 'an archive within an archive is not opened',
  });
}
