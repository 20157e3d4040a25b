import { decodeText } from '../text/decode-text.ts';

/** A file of an archive, as the archive's directory has it: none of it is checked but to lie within. */
export interface ZipEntry {
  readonly name: string;
  readonly isEncrypted: boolean;
  readonly method: number;
  readonly checksum: number;
  readonly size: number;
  /** (packedSize) */
  readonly packed: Uint8Array;
}

const endSignature = 0x06054b50;
const entrySignature = 0x02014b50;
const localSignature = 0x04034b50;
const endSize = 22;
const longestComment = 0xffff;

/**
 * The files that a zip archive's directory lists (PKWARE APPNOTE 6.3.10, 4.3), or what is wrong with
 * it. Read from the directory, not from one file to the next, since only it is sure to be whole.
 */
export function readDirectory(bytes: Uint8Array): readonly ZipEntry[] | string {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const end = findEnd(view);
  if (end === undefined) return 'no directory at its end';
  const count = view.getUint16(end + 10, true);
  let at = view.getUint32(end + 16, true);
  if (count === 0xffff || at === 0xffffffff) return 'a zip64 archive';
  const entries: ZipEntry[] = [];
  for (let i = 0; i < count; i++) {
    if (at + 46 > end || view.getUint32(at, true) !== entrySignature) return 'a broken directory';
    const nameEnd = at + 46 + view.getUint16(at + 28, true);
    const name = decodeText(bytes.subarray(at + 46, nameEnd)).replaceAll('\\', '/');
    const packed = packedBytes(bytes, view, at);
    if (!packed) return `"${name}" outside the archive`;
    entries.push({
      name,
      isEncrypted: (view.getUint16(at + 8, true) & 1) === 1,
      method: view.getUint16(at + 10, true),
      checksum: view.getUint32(at + 16, true),
      size: view.getUint32(at + 24, true),
      packed,
    });
    at = nameEnd + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
  }
  return entries;
}

/** The end record stands last but for a comment. */
function findEnd(view: DataView): number | undefined {
  const last = view.byteLength - endSize;
  for (let at = last; at >= Math.max(0, last - longestComment); at--) {
    if (view.getUint32(at, true) === endSignature) return at;
  }
  return undefined;
}

/** What follows the local header of a directory's entry, which has lengths of its own. */
function packedBytes(bytes: Uint8Array, view: DataView, entry: number): Uint8Array | undefined {
  const local = view.getUint32(entry + 42, true);
  if (local + 30 > bytes.length || view.getUint32(local, true) !== localSignature) return undefined;
  const start = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
  const size = view.getUint32(entry + 20, true);
  return size <= bytes.length - start ? bytes.subarray(start, start + size) : undefined;
}
