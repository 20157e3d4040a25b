import { Fragment } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import type { PageState } from '../editor.ts';
import { contexts, keyRows, pointerRows } from '../commands/contexts.ts';

/** Lists all keys and the actions of the pointer, while it is open. */
export function HelpSheet({ editor }: { readonly editor: PageState }) {
  const { helpOpen, letterKeys } = editor;
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const sheet = dialog.current;
    sheet?.showModal();
    // Closing returns the focus to where it was.
    return () => sheet?.close();
  }, []);
  const sections = [
    { label: '', rows: pointerRows },
    ...contexts.map(({ id, label }) => ({ label, rows: keyRows(id) })).reverse(),
  ];
  // The event comes with the next frame, when this sheet may be gone and another one open.
  const close = () => {
    if (dialog.current) helpOpen.value = false;
  };
  return (
    <dialog ref={dialog} aria-labelledby="help-title" onClose={close}>
      {/* The button comes first, so that the focus and the scroll position start at the top. */}
      <header>
        <h2 id="help-title">Keys and pointer</h2>
        <button type="button" onClick={() => (helpOpen.value = false)}>
          Close
        </button>
      </header>
      <table>
        <tbody>
          {sections.map(({ label: title, rows }, section) => (
            <Fragment key={section}>
              {title !== '' && (
                <tr>
                  <th scope="colgroup" colSpan={2}>
                    {title}
                  </th>
                </tr>
              )}
              {rows.map(([key, label]) => (
                <tr key={key}>
                  <th scope="row">
                    <kbd>{key}</kbd>
                  </th>
                  <td>{label}</td>
                </tr>
              ))}
            </Fragment>
          ))}
        </tbody>
      </table>
      <label class="check">
        <input
          type="checkbox"
          checked={letterKeys.value}
          onChange={({ currentTarget }) => (letterKeys.value = currentTarget.checked)}
        />
        Single letters act
      </label>
    </dialog>
  );
}
