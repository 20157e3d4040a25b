import { selectedCharacter } from '../../document/document.ts';
import type { Editor } from '../editor.ts';
import { chooseFiles } from '../choose-files.ts';

/** The bundled characters, and the way to one's own. */
export function CharactersPanel({ editor }: { readonly editor: Editor }) {
  const { bundled, openedId, fileExtensions } = editor;
  const state = selectedCharacter(editor.store.document.value);
  const isOwn = state !== undefined && openedId.value === null;
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
        {isOwn && (
          <li>
            <button type="button" aria-pressed={true} disabled>
              {state.character.name}
            </button>
          </li>
        )}
      </ul>
      <button
        type="button"
        class="primary"
        onClick={() => chooseFiles(fileExtensions, (files) => void editor.openFiles(files))}
      >
        Open files…
      </button>
      <p class="hint">
        or drop {fileExtensions.join(', ')} anywhere. Files never leave this machine.
      </p>
    </section>
  );
}
