import { printable } from '../../core/diagnostics.ts';
import { selectedCharacter } from '../../document/document.ts';
import { chooseFiles } from '../choose-files.ts';
import type { Editor } from '../editor.ts';

const saveTargets = [
  ['mit', '6.837 files'],
  ['cse169', 'CSE169 files'],
] as const;

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
      {shown && (
        <div class="save-as">
          <span id="save-as">Save as</span>
          {saveTargets.map(([format, label]) => (
            <button
              key={format}
              type="button"
              aria-describedby="save-as"
              onClick={() => void editor.saveAs(format)}
            >
              {label}
            </button>
          ))}
        </div>
      )}
      <p class="hint">
        or drop them anywhere: {fileExtensions.join(', ')}. Files never leave this machine.
      </p>
    </section>
  );
}
