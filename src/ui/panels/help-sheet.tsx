import { Fragment } from 'preact';
import type { PageState } from '../editor.ts';
import { contexts, keyRows, pointerRows } from '../commands/contexts.ts';

/** Lists all keys and the actions of the pointer. */
export function HelpSheet({ editor }: { readonly editor: PageState }) {
  const { letterKeys } = editor;
  const sections = [
    { label: '', rows: pointerRows },
    ...contexts.map(({ id, label }) => ({ label, rows: keyRows(id) })).reverse(),
  ];
  return (
    <>
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
    </>
  );
}
