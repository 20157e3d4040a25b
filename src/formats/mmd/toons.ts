import type { BinaryReader } from '../binary/binary-reader.ts';
import { decodeName } from './decode-name.ts';

const [count, size] = [10, 100];

/** Reads the names of the ten toon ramp images. */
export function readToons(reader: BinaryReader): string[] | undefined {
  const records = reader.record(count * size, 'the names of toon textures');
  if (!records) return undefined;
  return Array.from({ length: count }, (_, index) => decodeName(records.bytes(index * size, size)));
}
