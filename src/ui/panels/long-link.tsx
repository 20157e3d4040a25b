import type { Editor } from '../editor.ts';
import { CommandButton } from './command-button.tsx';

/** Offers the scene file in place of a link that is too long. */
export function LongLink({ editor }: { readonly editor: Editor }) {
  const close = (): void => void (editor.dialog.value = null);
  return (
    <>
      <p>
        This scene is too large for a link: many programs cut addresses past 8 KB. A scene file
        holds all of it, and opens where it is dropped.
      </p>
      <div class="buttons">
        <CommandButton editor={editor} command="save-scene-as" onRun={close} />
      </div>
    </>
  );
}
