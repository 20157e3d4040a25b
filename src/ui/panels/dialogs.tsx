import { useLayoutEffect, useRef } from 'preact/hooks';
import { dialogs } from '../dialogs.ts';
import type { DialogId, Editor } from '../editor.ts';
import { Loaded } from './loaded.tsx';

/** The dialog that is open, if any. */
export function Dialogs({ editor }: { readonly editor: Editor }) {
  const id = editor.dialog.value;
  return id === null ? null : <Dialog key={id} editor={editor} id={id} />;
}

/** A sheet over the page with a heading; closing it returns the focus to where it was. */
function Dialog({ editor, id }: { readonly editor: Editor; readonly id: DialogId }) {
  const sheet = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => {
    const opened = sheet.current;
    opened?.showModal();
    return () => opened?.close();
  }, []);
  const close = (): void => {
    // The event of closing comes with the next frame, when another dialog may be open.
    if (editor.dialog.value === id && sheet.current) editor.dialog.value = null;
  };
  const { title, load } = dialogs[id];
  return (
    <dialog
      ref={sheet}
      class={id}
      aria-labelledby="dialog-title"
      onCancel={close} // at once, whereas the event of closing comes with the next frame
      onClose={close}
      onPointerDown={(event) => isBeside(event) && close()}
    >
      {/* The button comes first, so that the focus and the scroll position start at the top. */}
      <header>
        <h2 id="dialog-title">{title}</h2>
        <button type="button" onClick={close}>
          Close
        </button>
      </header>
      <Loaded editor={editor} load={load} />
    </dialog>
  );
}

/** Whether the pointer is on the backdrop, which counts as the dialog but is outside of its box. */
function isBeside({ currentTarget, clientX, clientY }: PointerEvent): boolean {
  const { left, right, top, bottom } = (currentTarget as Element).getBoundingClientRect();
  return clientX < left || clientX > right || clientY < top || clientY > bottom;
}
