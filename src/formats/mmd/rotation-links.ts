import type { RotationLink } from '../../core/character-parts.ts';
import { type MmdBone, MmdBoneType } from './mmd-parts.ts';

/**
 * Returns which bones copy rotations of others: those of type 5 (回転影響下) the whole rotation of the
 * bone that they name, as both eyes copy that of 両目; those of type 9 (回転連動), such as the twist
 * bones of an arm, a percentage of that of their tail. A link to no other bone is none.
 */
export function rotationLinks(
  bones: readonly Pick<MmdBone, 'type' | 'tail' | 'ikParent'>[],
): readonly RotationLink[] {
  return bones.flatMap(({ type, tail, ikParent }, joint): RotationLink[] => {
    const isWhole = type === MmdBoneType.underRotation;
    if (!isWhole && type !== MmdBoneType.rotationLink) return [];
    const source = isWhole ? ikParent : tail;
    const exists = source > 0 && source < bones.length && source !== joint;
    return exists ? [{ joint, source, ratio: isWhole ? 1 : ikParent / 100 }] : [];
  });
}
