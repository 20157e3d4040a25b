import {
  endSignature,
  entrySignature,
  entryHead,
  localSignature,
  type RawEntry,
  withNames,
  type ZipEntry,
} from './directory.ts';

const descriptorSignature = 0x08074b50;
const descriptorFlag = 0x0008;

/**
 * Finds the files of an archive without a directory, for example one that was cut short, from one
 * local header to the next (APPNOTE 4.3.7). If a file's sizes follow it, they determine its end.
 */
export function recoverEntries(bytes: Uint8Array): readonly ZipEntry[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const entries: RawEntry[] = [];
  let at = 0;
  while (at + 30 <= bytes.length && view.getUint32(at, true) === localSignature) {
    const nameEnd = at + 30 + view.getUint16(at + 26, true);
    const start = nameEnd + view.getUint16(at + 28, true);
    const isDescribed = (view.getUint16(at + 6, true) & descriptorFlag) !== 0;
    const sizes = isDescribed ? findSizes(view, start) : sizesAt(view, at + 14, start);
    if (start > bytes.length) break;
    entries.push({
      ...entryHead(view, at + 6, bytes.subarray(at + 30, nameEnd), bytes.subarray(nameEnd, start)),
      isFolder: false, // local headers have no attributes
      checksum: sizes ? view.getUint32(sizes.at, true) : 0,
      size: sizes ? view.getUint32(sizes.at + 8, true) : 0,
      packed: sizes && sizes.end <= bytes.length ? bytes.subarray(start, sizes.end) : undefined,
    });
    if (!sizes) break;
    at = isDescribed ? sizes.at + 12 : sizes.end;
  }
  return withNames(entries);
}

/** Checksum, packed size and size of a file, and where the file ends. */
interface Sizes {
  readonly at: number;
  readonly end: number;
}

function sizesAt(view: DataView, at: number, start: number): Sizes {
  return { at, end: start + view.getUint32(at + 4, true) };
}

/**
 * Finds the sizes that follow a file: after an optional signature of their own, or directly before
 * a header.
 */
function findSizes(view: DataView, start: number): Sizes | undefined {
  for (let end = start; end + 16 <= view.byteLength; end++) {
    const isSigned = view.getUint32(end, true) === descriptorSignature;
    if (!isSigned && !isHeader(view.getUint32(end + 12, true))) continue;
    const at = isSigned ? end + 4 : end;
    if (sizesAt(view, at, start).end === end) return { at, end };
  }
  return undefined;
}

function isHeader(signature: number): boolean {
  return [localSignature, entrySignature, endSignature].includes(signature);
}
