import type { BinaryWriter } from '../binary/binary-writer.ts';
import { encodeName } from './encode-name.ts';
import type { PmdHeader } from './header.ts';

/** Writes the signature, version, name and comment. */
export function writeHeader(out: BinaryWriter, { version, modelName, comment }: PmdHeader): void {
  out.bytes(new TextEncoder().encode('Pmd'));
  out.f32(version);
  out.bytes(encodeName(modelName, 20));
  out.bytes(encodeName(comment, 256));
}
