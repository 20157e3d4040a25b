import { printable } from '../../core/diagnostics.ts';
import { baseName } from '../../formats/file-entry.ts';
import { chooseFiles } from '../choose-files.ts';
import type { Editor } from '../editor.ts';

/** More would not be read. */
const mostNames = 12;

/** Asks for the files that an opened scene still needs. They may be dropped anywhere as well. */
export function Wanted({ editor }: { readonly editor: Editor }) {
  const wanted = editor.wanted.value;
  if (!wanted) return <p role="status">The scene has all of its files</p>;
  const { files, scene } = wanted;
  const more = files.length - mostNames;
  return (
    <>
      <p>
        {printable(scene, 60)} does not contain the characters’ own files, which stay with who has
        them. Drop these here, or choose them:
      </p>
      <ul class="names">
        {files.slice(0, mostNames).map((path) => (
          <li key={path}>{printable(baseName(path), 80)}</li>
        ))}
        {more > 0 && <li>and {more} more</li>}
      </ul>
      <div class="buttons">
        <button
          type="button"
          class="primary"
          onClick={() => chooseFiles(editor, editor.fileExtensions, true)}
        >
          Choose files…
        </button>
        <button type="button" onClick={() => (editor.dialog.value = null)}>
          Leave them out
        </button>
      </div>
    </>
  );
}
