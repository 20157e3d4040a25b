import type { BinaryWriter } from '../binary/binary-writer.ts';
import { encodeName } from './encode-name.ts';
import type { MmdEnglish } from './mmd-parts.ts';

/** Writes the English names, or that there are none. */
export function writeEnglish(out: BinaryWriter, english: MmdEnglish | undefined): void {
  out.u8(english ? 1 : 0);
  if (!english) return;
  const { modelName, comment, boneNames, morphNames, groupNames } = english;
  out.bytes(encodeName(modelName, 20));
  out.bytes(encodeName(comment, 256));
  for (const name of [...boneNames, ...morphNames]) out.bytes(encodeName(name, 20));
  for (const name of groupNames) out.bytes(encodeName(name, 50));
}
