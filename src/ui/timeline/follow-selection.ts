import { effect, untracked } from '@preact/signals-core';
import type { ClipParts } from '../../core/motion/clip-parts.ts';
import type { KeySelection } from '../../core/motion/key-selection.ts';
import type { Editor } from '../editor.ts';
import { chosenClip } from '../clips.ts';

type FollowedEditor = Pick<Editor, 'store' | 'session' | 'transport'>;

/** By each state of a clip, the keys that were selected in it last. */
const selections = new WeakMap<ClipParts, KeySelection>();

/**
 * Lets undo and redo bring back the selected keys that went with a clip, since the times of those
 * selected now may be keys of the clip that was left only.
 *
 * @returns a function that ends it
 */
export function followKeySelection(editor: FollowedEditor): () => void {
  const { selectedKeys } = editor.session;
  let former: ClipParts | undefined;
  return effect(() => {
    const clip = chosenClip(editor)?.clip;
    const selection = selectedKeys.value;
    if (!clip) return;
    const known = clip === former ? undefined : selections.get(clip);
    former = clip;
    if (known && known !== selection) untracked(() => (selectedKeys.value = known));
    else selections.set(clip, selection);
  });
}
