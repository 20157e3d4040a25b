import { useEffect, useRef } from 'preact/hooks';
import type { Editor } from '../editor.ts';
import { everywhere, keyName, pointerHelp, withCommand } from '../keymap.ts';

/** The keys and what the pointer does. */
export function HelpSheet({ editor }: { readonly editor: Editor }) {
  const { helpOpen, letterKeys } = editor;
  const dialog = useRef<HTMLDialogElement>(null);
  const open = helpOpen.value;
  useEffect(() => {
    if (open) dialog.current?.showModal();
    else dialog.current?.close();
  }, [open]);
  const rows = [
    ...pointerHelp,
    ...[...everywhere, ...withCommand].map((key) => [keyName(key), key.label] as const),
  ];
  return (
    <dialog ref={dialog} aria-labelledby="help-title" onClose={() => (helpOpen.value = false)}>
      <h2 id="help-title">Keys and pointer</h2>
      <table>
        <tbody>
          {rows.map(([key, label]) => (
            <tr key={key}>
              <th scope="row">
                <kbd>{key}</kbd>
              </th>
              <td>{label}</td>
            </tr>
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
      <button type="button" onClick={() => (helpOpen.value = false)}>
        Close
      </button>
    </dialog>
  );
}
