import { noParent, type Skeleton } from '../../core/skeleton.ts';
import type { BinaryWriter } from '../binary/binary-writer.ts';
import { encodeName } from './encode-name.ts';
import { mirrorPoint } from './mirror.ts';
import type { MmdBone } from './mmd-parts.ts';

const none = 0xffff;

/** The file has 0 for a bone without a tail. */
const noTail = 0;

/** Writes `count × (name, parent, tail, type, IK parent, position of the head)`. */
export function writeBones(
  out: BinaryWriter,
  names: readonly string[],
  { parents, jointOfSource, sourceIndex }: Skeleton,
  bones: readonly MmdBone[],
): void {
  out.u16(bones.length);
  bones.forEach(({ type, tail, ikParent, head }, index) => {
    const parent = parents[jointOfSource[index]!]!;
    out.bytes(encodeName(names[index]!, 20));
    out.u16(parent === noParent ? none : sourceIndex[parent]!, tail === -1 ? noTail : tail);
    out.u8(type);
    out.u16(ikParent === -1 ? none : ikParent);
    out.f32(...mirrorPoint(head));
  });
}
