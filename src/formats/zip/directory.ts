import { decodeNames, type RawName } from './entry-names.ts';

/** A file of an archive, as the archive's directory lists it; nothing of it is checked. */
export interface ZipEntry {
  readonly name: string;
  /** Whether its attributes are those of a folder. */
  readonly isFolder: boolean;
  readonly isEncrypted: boolean;
  readonly method: number;
  readonly checksum: number;
  readonly size: number;
  /** Undefined if the directory gives a place outside the archive. */
  readonly packed: Uint8Array | undefined;
}

export interface RawEntry extends Omit<ZipEntry, 'name'> {
  readonly name: RawName;
}

export const endSignature = 0x06054b50;
export const entrySignature = 0x02014b50;
export const localSignature = 0x04034b50;
const endSize = 22;
const longestComment = 0xffff;
const encryptedFlag = 0x0001;
const utf8Flag = 0x0800;

/**
 * Returns the files that a zip archive's directory lists (PKWARE APPNOTE 6.3.10, 4.3), or what is
 * wrong with it. It reads the directory instead of the files' own headers, because only the
 * directory is certain to be complete.
 */
export function readDirectory(bytes: Uint8Array): readonly ZipEntry[] | string {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const end = findEnd(view);
  if (end === undefined) return 'no directory at its end';
  const count = view.getUint16(end + 10, true);
  const start = view.getUint32(end + 16, true);
  if (count === 0xffff || start === 0xffffffff) return 'a zip64 archive';
  // Offsets count from the start of the archive, before which there may be a self-extracting
  // program.
  const shift = Math.max(0, end - view.getUint32(end + 12, true) - start);
  const entries: RawEntry[] = [];
  let at = start + shift;
  for (let i = 0; i < count; i++) {
    if (at + 46 > end || view.getUint32(at, true) !== entrySignature) return 'a broken directory';
    const nameEnd = at + 46 + view.getUint16(at + 28, true);
    const extraEnd = nameEnd + view.getUint16(at + 30, true);
    const [name, extra] = [bytes.subarray(at + 46, nameEnd), bytes.subarray(nameEnd, extraEnd)];
    const local = view.getUint32(at + 42, true) + shift;
    entries.push({
      ...entryHead(view, at + 8, name, extra),
      isFolder: isFolder(view.getUint32(at + 38, true)),
      checksum: view.getUint32(at + 16, true),
      size: view.getUint32(at + 24, true),
      packed: packedBytes(bytes, view, local, view.getUint32(at + 20, true)),
    });
    at = extraEnd + view.getUint16(at + 32, true);
  }
  return withNames(entries);
}

/** The attributes of DOS have a bit for folders; those of Unix, above them, have a kind of file. */
function isFolder(attributes: number): boolean {
  return (attributes & 0x10) !== 0 || ((attributes >>> 28) & 0xf) === 4;
}

export function withNames(entries: readonly RawEntry[]): ZipEntry[] {
  const names = decodeNames(entries.map(({ name }) => name));
  return entries.map((entry, index) => ({ ...entry, name: names[index]! }));
}

/**
 * Reads what the directory and a file's own header have in common: flags, then the method.
 *
 * @param at offset of the flags
 */
export function entryHead(
  view: DataView,
  at: number,
  name: Uint8Array,
  extra: Uint8Array,
): Pick<RawEntry, 'name' | 'isEncrypted' | 'method'> {
  const flags = view.getUint16(at, true);
  return {
    name: { bytes: name, isUtf8: (flags & utf8Flag) !== 0, extra },
    isEncrypted: (flags & encryptedFlag) !== 0,
    method: view.getUint16(at + 2, true),
  };
}

/** The end record is last, except for a comment. */
function findEnd(view: DataView): number | undefined {
  const last = view.byteLength - endSize;
  for (let at = last; at >= Math.max(0, last - longestComment); at--) {
    if (view.getUint32(at, true) === endSignature) return at;
  }
  return undefined;
}

/** The bytes after the local header of a directory's entry; that header has lengths of its own. */
function packedBytes(
  bytes: Uint8Array,
  view: DataView,
  local: number,
  size: number,
): Uint8Array | undefined {
  if (local + 30 > bytes.length || view.getUint32(local, true) !== localSignature) return undefined;
  const start = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
  return size <= bytes.length - start ? bytes.subarray(start, start + size) : undefined;
}
