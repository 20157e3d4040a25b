import type { BinaryWriter } from '../binary/binary-writer.ts';
import { encodeName } from './encode-name.ts';

/** Writes the names of the ten toon ramp images. */
export function writeToons(out: BinaryWriter, toons: readonly string[]): void {
  for (const name of toons) out.bytes(encodeName(name, 100));
}
