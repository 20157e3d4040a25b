import { useEffect, useState } from 'preact/hooks';
import { printable } from '../../core/diagnostics.ts';
import { attempt } from '../attempt.ts';
import type { EarlierScene, Editor } from '../editor.ts';
import { fitsQuery } from '../rank-entries.ts';
import { timeText } from '../time-text.ts';

interface EarlierScenesProperties {
  readonly editor: Editor;
  /** What is searched for. */
  readonly typed: string;
  /** Runs when one is opened. */
  readonly onOpen: () => void;
}

/** The scenes of earlier visits and other tabs, which this browser keeps. */
export function EarlierScenes({ editor, typed, onOpen }: EarlierScenesProperties) {
  const [earlier, setEarlier] = useState<readonly EarlierScene[]>([]);
  useEffect(() => attempt(editor, editor.listEarlier().then(setEarlier)), [editor]);
  const listed = earlier.filter(({ name }) => fitsQuery(`${name} scene`, typed));
  if (listed.length === 0) return null;
  return (
    <section aria-label="Earlier scenes">
      <h3>
        Earlier scenes <small>kept in this browser, in place of all characters</small>
      </h3>
      <ul class="names">
        {listed.map(({ id, name, time }) => (
          <li key={id}>
            <button
              type="button"
              onClick={() => {
                onOpen();
                attempt(editor, editor.openEarlier(id));
              }}
            >
              {printable(name, 60)} <small>{timeText(new Date(time), new Date())}</small>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
