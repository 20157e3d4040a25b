import type { BinaryWriter } from '../binary/binary-writer.ts';
import { encodeName } from './encode-name.ts';
import type { MmdDisplay } from './mmd-parts.ts';

/** Writes the order and groups in which a program lists morphs and bones. */
export function writeDisplay(out: BinaryWriter, { morphs, groupNames, bones }: MmdDisplay): void {
  out.u8(morphs.length);
  out.u16(...morphs);
  out.u8(groupNames.length);
  for (const name of groupNames) out.bytes(encodeName(name, 50));
  out.u32(bones.length);
  for (const { bone, group } of bones) {
    out.u16(bone);
    out.u8(group);
  }
}
