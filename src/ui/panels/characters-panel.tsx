import { printable } from '../../core/diagnostics.ts';
import { selectedCharacter } from '../../document/document.ts';
import { chooseFiles } from '../choose-files.ts';
import type { Editor } from '../editor.ts';

/** The bundled characters, one's own, and the way to more. */
export function CharactersPanel({ editor }: { readonly editor: Editor }) {
  const { bundled, own, openedId, fileExtensions } = editor;
  const shown = selectedCharacter(editor.store.document.value)?.character;
  const open = (folder: boolean): void =>
    chooseFiles(folder ? null : fileExtensions, (files) => void editor.openFiles(files));
  return (
    <section aria-labelledby="characters-title">
      <h2 id="characters-title">Characters</h2>
      <ul class="picker">
        {bundled.value.map(({ id, label, credit }) => (
          <li key={id}>
            <button
              type="button"
              title={credit}
              aria-pressed={id === openedId.value}
              onClick={() => void editor.openBundled(id)}
            >
              {label}
            </button>
          </li>
        ))}
        {own.value.map((read, index) => (
          <li key={`own ${index}`}>
            <button
              type="button"
              title="From your files"
              aria-pressed={read.character === shown}
              onClick={() => editor.openOwn(read)}
            >
              {printable(read.character.name, 80)}
            </button>
          </li>
        ))}
      </ul>
      <button type="button" class="primary" onClick={() => open(false)}>
        Open files…
      </button>
      <button type="button" class="wide" onClick={() => open(true)}>
        Open folder…
      </button>
      <p class="hint">
        or drop them anywhere: {fileExtensions.join(', ')}. Files never leave this machine.
      </p>
    </section>
  );
}
