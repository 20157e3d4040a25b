import type { ClipParts } from '../core/motion/clip-parts.ts';
import type { Converted } from './convert.ts';
import { writeAnimOf } from './cse169/anim-of-clip.ts';
import type { Written } from './format.ts';
import { writeMotion } from './motion/write-motion.ts';
import { type ConvertTarget, shapeOf } from './registry.ts';

/**
 * Writes a motion of a character as its converted files hold it: an `.anim` where the format has
 * clips, otherwise a MOTION.json.
 */
export function writeConvertedMotion(
  motion: ClipParts,
  { character, pose, convertClip }: Converted,
  to: ConvertTarget,
): Written {
  const { clip, losses } = convertClip(motion);
  const written = shapeOf(to).clips
    ? writeAnimOf(clip, character.skeleton, pose.q)
    : writeMotion(clip, character);
  return { files: written.files, losses: [...losses, ...written.losses] };
}

/**
 * Writes the motions beside a converted character. Where an `.anim` loses something, a MOTION.json
 * that loses less comes with it. No loss of a motion is an error, since the character is saved.
 */
export function writeMotionsBeside(
  clips: readonly ClipParts[],
  converted: Converted,
  to: ConvertTarget,
): Written {
  const all = clips.map((clip) => {
    const { files, losses } = writeConvertedMotion(clip, converted, to);
    if (!shapeOf(to).clips || losses.length === 0) return { files, losses };
    const { clip: moved } = converted.convertClip(clip);
    const beside = writeMotion(moved, converted.character);
    return { files: [...files, ...beside.files], losses };
  });
  return {
    files: all.flatMap(({ files }) => files),
    losses: all.flatMap(({ losses }) => losses).map((each) => ({ ...each, severity: 'warning' })),
  };
}
