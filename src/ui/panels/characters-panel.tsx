import { useState } from 'preact/hooks';
import { printable } from '../../core/diagnostics.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { convertTargets, labelOf } from '../../formats/registry.ts';
import { attempt } from '../attempt.ts';
import type { Editor } from '../editor.ts';
import { CommandButton } from './command-button.tsx';

/**
 * Lists the characters of the scene, the bundled characters and the user's own, with the menus to
 * add more.
 */
export function CharactersPanel({ editor }: { readonly editor: Editor }) {
  const { bundled, own, openedId, fileExtensions } = editor;
  const shown = selectedActor(editor.store, editor.session)?.character;
  const ownNames = numberedNames(own.value.map(({ character }) => character.name));
  return (
    <section aria-labelledby="characters-title">
      <SceneList editor={editor} />
      <h2 id="characters-title">Characters</h2>
      <ul class="picker">
        {bundled.value.map(({ id, label, credit }) => (
          <li key={id}>
            <button
              type="button"
              title={credit}
              aria-pressed={id === openedId.value}
              onClick={() => attempt(editor, editor.openBundled(id))}
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
              {ownNames[index]}
            </button>
          </li>
        ))}
      </ul>
      <CommandButton editor={editor} command="open-files" class="primary" />
      <CommandButton editor={editor} command="open-folder" class="wide" />
      <AddMenu editor={editor} ownNames={ownNames} />
      {shown && (
        <div class="save-as">
          <span id="save-as">Save as</span>
          {convertTargets.map((format) => (
            <button
              key={format}
              type="button"
              aria-describedby="save-as"
              onClick={() => attempt(editor, editor.saveAs(format))}
            >
              {labelOf(format)}
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

interface AddMenuProperties {
  readonly editor: Editor;
  /** Names of the user's own characters. */
  readonly ownNames: readonly string[];
}

/** Adds a character and keeps the others, whereas the list above replaces the selected one. */
function AddMenu({ editor, ownNames }: AddMenuProperties) {
  const [open, setOpen] = useState(false);
  const add = (label: string, run: () => void) => (
    <li key={label}>
      <button
        type="button"
        onClick={() => {
          setOpen(false);
          run();
        }}
      >
        {label}
      </button>
    </li>
  );
  return (
    <>
      <button type="button" class="wide" aria-expanded={open} onClick={() => setOpen(!open)}>
        Add to the scene…
      </button>
      {open && (
        <ul class="picker" aria-label="Add to the scene">
          {editor.bundled.value.map(({ id, label }) =>
            add(`Add ${label}`, () => attempt(editor, editor.openBundled(id, true))),
          )}
          {editor.own.value.map((read, index) =>
            add(`Add ${ownNames[index]!}`, () => editor.openOwn(read, true)),
          )}
          <li>
            <CommandButton editor={editor} command="add-files" onRun={() => setOpen(false)} />
          </li>
        </ul>
      )}
    </>
  );
}

/** The actors, one of them selected; a scene with one actor shows no list. */
function SceneList({ editor }: { readonly editor: Editor }) {
  const { actors } = editor.store.scene.value;
  const selected = editor.session.selectedActorId.value;
  if (actors.length < 2) return null;
  const names = numberedNames(actors.map(({ character }) => character.name));
  return (
    <>
      <h2 id="scene-title">Scene ({actors.length})</h2>
      <ul class="picker scene-list" aria-labelledby="scene-title">
        {actors.map(({ id }, index) => (
          <li key={id}>
            <button type="button" aria-pressed={id === selected} onClick={() => editor.select(id)}>
              {names[index]}
            </button>
          </li>
        ))}
      </ul>
      <div class="buttons">
        <CommandButton editor={editor} command="duplicate-character" />
        <CommandButton editor={editor} command="remove-character" />
      </div>
    </>
  );
}

/** Numbers repeated names ("human", "human 2"), so that copies can be told apart. */
function numberedNames(names: readonly string[]): string[] {
  return names.map((name, index) => {
    const before = names.slice(0, index).filter((other) => other === name).length;
    return `${printable(name, 80)}${before === 0 ? '' : ` ${before + 1}`}`;
  });
}
