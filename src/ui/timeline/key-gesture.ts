import type { ClipParts } from '../../core/motion/clip-parts.ts';
import type { EditedKeys } from '../../core/motion/edit/selection.ts';
import type { KeySelection } from '../../core/motion/key-selection.ts';
import { editClip } from '../../document/clip-edits.ts';
import type { Editor } from '../editor.ts';
import { chosenClip } from '../clips.ts';

/** Returns an edited clip and what is selected then, from those at which a gesture began. */
export type KeyEdit = (clip: ClipParts, selection: KeySelection) => EditedKeys;

/** An edit of keys in progress: a step of undo of its own, and the selection that goes with it. */
export interface KeyGesture {
  /** False after it was canceled, by any code. */
  readonly isOpen: boolean;
  /** Shows the result of the edit on the clip at which the gesture began. */
  preview(edit: KeyEdit): void;
  commit(): void;
  cancel(): void;
}

/** Begins to edit the keys of the clip that the timeline shows, if there is one. */
export function beginKeyGesture(editor: Editor, label: string): KeyGesture | null {
  const { store, session } = editor;
  const chosen = chosenClip(editor);
  if (!chosen) return null;
  const { actor, clip, index } = chosen;
  const selection = session.selectedKeys.value;
  const gesture = store.begin(label);
  return {
    get isOpen() {
      return gesture.isOpen;
    },
    preview: (edit) => {
      if (!gesture.isOpen) return;
      const edited = edit(clip, selection);
      gesture.preview(editClip(actor.id, index, label, () => edited.clip));
      session.selectedKeys.value = edited.selection;
    },
    commit: () => gesture.commit(),
    cancel: () => {
      gesture.cancel();
      session.selectedKeys.value = selection;
    },
  };
}

/** Edits the keys of the clip that the timeline shows as one step of undo. */
export function editKeys(editor: Editor, label: string, edit: KeyEdit): void {
  const gesture = beginKeyGesture(editor, label);
  gesture?.preview(edit);
  gesture?.commit();
}
