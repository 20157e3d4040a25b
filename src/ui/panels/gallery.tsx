import { useEffect, useState } from 'preact/hooks';
import { printable } from '../../core/diagnostics.ts';
import { isUntouched } from '../../document/untouched.ts';
import { attempt } from '../attempt.ts';
import { chooseFiles } from '../choose-files.ts';
import type { BundledCharacter, Editor, RecentFiles } from '../editor.ts';
import { numberedNames } from '../numbered-names.ts';
import { fitsQuery } from '../rank-entries.ts';
import { shelvesOf } from '../shelves.ts';
import { CommandButton } from './command-button.tsx';
import { EarlierScenes } from './earlier-scenes.tsx';

/**
 * The characters that can be added: bundled ones as pictures, a shelf a course, and the user's own.
 * A press adds one beside the others, or in place of a scene that nobody touched, and closes the
 * gallery unless Shift is held.
 */
export function Gallery({ editor }: { readonly editor: Editor }) {
  const [typed, setTyped] = useState('');
  const shelves = shelvesOf(editor.bundled.value, typed);
  const scenes = editor.scenes.filter(({ label }) => fitsQuery(`${label} scene`, typed));
  const names = numberedNames(editor.own.value.map(({ character }) => character.name));
  const own = editor.own.value
    .map((read, index) => ({ read, name: names[index]! }))
    .filter(({ name }) => fitsQuery(name, typed));
  const close = (): void => void (editor.dialog.value = null);
  const closeUnlessHeld = ({ shiftKey }: MouseEvent): void => {
    if (!shiftKey) close();
  };
  return (
    <>
      <div class="find">
        <input
          type="search"
          placeholder="Search characters"
          aria-label="Search characters"
          value={typed}
          onInput={({ currentTarget }) => setTyped(currentTarget.value)}
        />
        <CommandButton editor={editor} command="open-files" onRun={close} />
        <CommandButton editor={editor} command="open-folder" onRun={close} />
      </div>
      <p class="hint">Or drop files anywhere. They never leave this machine.</p>
      {shelves.map(({ label, files, cards }) => (
        <section key={label} aria-label={label}>
          <h3>
            {label} <small>{files}</small>
          </h3>
          <ul class="cards">
            {cards.map((card) => (
              <Card
                key={card.id}
                card={card}
                title={`${card.credit}. Shift keeps the gallery open.`}
                theme={editor.viewer.theme.value}
                onPress={(event) => {
                  closeUnlessHeld(event);
                  attempt(editor, editor.addBundled(card.id));
                }}
              />
            ))}
          </ul>
        </section>
      ))}
      {scenes.length > 0 && (
        <section aria-label="Scenes">
          <h3>
            Scenes <small>in place of all characters</small>
          </h3>
          <ul class="cards">
            {scenes.map((scene) => (
              <Card
                key={scene.id}
                card={scene}
                title={`Open ${scene.label}`}
                theme={editor.viewer.theme.value}
                onPress={() => {
                  close();
                  attempt(editor, editor.openBundledScene(scene.id));
                }}
              />
            ))}
          </ul>
        </section>
      )}
      {own.length > 0 && (
        <section aria-label="Your files">
          <h3>Your files</h3>
          <ul class="names">
            {own.map(({ read, name }) => (
              <li key={name}>
                <button
                  type="button"
                  onClick={(event) => {
                    closeUnlessHeld(event);
                    editor.openOwn(read, !isUntouched(editor.store));
                  }}
                >
                  {name}
                </button>
              </li>
            ))}
          </ul>
        </section>
      )}
      <EarlierScenes editor={editor} typed={typed} onOpen={close} />
      <Recent
        editor={editor}
        isListed={({ name }) => fitsQuery(name, typed) && !names.includes(name)}
        onPress={closeUnlessHeld}
      />
      {shelves.length + scenes.length + own.length === 0 && <p role="status">No character fits</p>}
    </>
  );
}

interface RecentProperties {
  readonly editor: Editor;
  readonly isListed: (recent: RecentFiles) => boolean;
  readonly onPress: (event: MouseEvent) => void;
}

/** What was opened at earlier visits; the browser finds some of it again. */
function Recent({ editor, isListed, onPress }: RecentProperties) {
  const [recent, setRecent] = useState<readonly RecentFiles[]>([]);
  useEffect(() => attempt(editor, editor.listRecent().then(setRecent)), [editor]);
  const listed = recent.filter(isListed);
  const open = (files: RecentFiles): void => {
    if (files.handles.length === 0) chooseFiles(editor, editor.fileExtensions);
    else attempt(editor, editor.openRecent(files));
  };
  const forget = (): void => {
    attempt(
      editor,
      editor.forgetRecent().then(() => setRecent([])),
    );
  };
  if (listed.length === 0) return null;
  return (
    <section aria-label="Recent">
      <h3>
        Recent <small>remembered in this browser</small>
      </h3>
      <ul class="names">
        {listed.map((files) => (
          <li key={files.name}>
            <button
              type="button"
              onClick={(event) => {
                onPress(event);
                open(files);
              }}
            >
              {printable(files.name, 80)}
              {files.handles.length === 0 && <small>choose it again</small>}
            </button>
          </li>
        ))}
        <li>
          <button type="button" class="plain" onClick={forget}>
            Forget these
          </button>
        </li>
      </ul>
    </section>
  );
}

interface CardProperties {
  readonly card: Pick<BundledCharacter, 'id' | 'label'>;
  readonly title: string;
  readonly theme: 'light' | 'dark';
  readonly onPress: (event: MouseEvent) => void;
}

function Card({ card: { id, label }, title, theme, onPress }: CardProperties) {
  return (
    <li>
      <button type="button" title={title} onClick={onPress}>
        <img src={`data/pictures/${id}-${theme}.jpg`} alt="" width="288" height="216" />
        {label}
      </button>
    </li>
  );
}
