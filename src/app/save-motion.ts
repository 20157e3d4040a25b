import { type Diagnostic, hasErrors } from '../core/diagnostics.ts';
import { writeAnimOf } from '../formats/cse169/anim-of-clip.ts';
import type { Written } from '../formats/format.ts';
import { writeMotion } from '../formats/motion/write-motion.ts';
import type { MotionForm } from '../ui/editor.ts';
import type { Actor } from '../document/scene.ts';
import { download } from '../ui/download.ts';

/**
 * Downloads a clip of an actor in one of the forms.
 *
 * @returns what the form can't hold; with an error, nothing was saved
 */
export function saveMotion(actor: Actor, index: number, form: MotionForm): readonly Diagnostic[] {
  const { files, losses } = written(actor, index, form);
  if (hasErrors(losses)) return losses;
  for (const { path, bytes } of files) download(path, bytes as BlobPart, 'text/plain');
  return losses;
}

function written({ clips, character, q }: Actor, index: number, form: MotionForm): Written {
  const clip = clips[index]!;
  return form === 'anim' ? writeAnimOf(clip, character.skeleton, q) : writeMotion(clip, character);
}
