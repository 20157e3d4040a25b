import { zipSync } from 'fflate';
import { crc32 } from '../../src/formats/crc32.ts';
import { ByteWriter } from './byte-writer.ts';
import { bytesOf, type FileContents } from './files.ts';

/** A zip archive of these files, compressed. */
export function zipOf(contents: FileContents): Uint8Array {
  const entries = Object.entries(contents).map(
    ([name, content]) => [name, bytesOf(content)] as const,
  );
  return zipSync(Object.fromEntries(entries), { level: 9, mtime: new Date(2020, 0) });
}

/** Fields of an entry of the directory: offset and size in bytes. */
const fields = {
  flags: [8, 2],
  method: [10, 2],
  checksum: [16, 4],
  packedSize: [20, 4],
  size: [24, 4],
  attributes: [38, 4],
  offset: [42, 4],
} as const;

/** The archive with other values in the first entry of its directory. */
export function patched(
  zip: Uint8Array,
  values: Readonly<Partial<Record<keyof typeof fields, number>>>,
): Uint8Array {
  const out = zip.slice();
  const view = new DataView(out.buffer);
  const entry = view.getUint32(out.length - 22 + 16, true);
  for (const [name, value] of Object.entries(values)) {
    const [at, size] = fields[name as keyof typeof fields];
    if (size === 2) view.setUint16(entry + at, value, true);
    else view.setUint32(entry + at, value, true);
  }
  return out;
}

/** An archive without a directory; each of its files is stored, and its sizes follow it. */
export function describedZip(contents: FileContents, isSigned: boolean): Uint8Array {
  const out = new ByteWriter();
  for (const [name, content] of Object.entries(contents)) {
    const bytes = bytesOf(content);
    out.u32(0x04034b50).u16(20, 8, 0, 0, 0).u32(0, 0, 0).u16(name.length, 0);
    out.field(name.length, name).field(bytes.length, [...bytes]);
    if (isSigned) out.u32(0x08074b50);
    out.u32(crc32(bytes), bytes.length, bytes.length);
  }
  out.u32(0x02014b50);
  return out.done();
}
