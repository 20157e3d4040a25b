import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { Editor } from '../editor.ts';
import { type PaletteEntry, paletteEntries } from '../palette-entries.ts';
import { rankEntries } from '../rank-entries.ts';

/** More rows than this are not listed; typing on finds them. */
const mostRows = 80;

/** As many entries as the palette remembers as recently used. */
const mostRecent = 20;

/**
 * Lists everything that can be done now and finds it by some of its letters. The focus stays in the
 * search field, and the arrow keys move the active row.
 */
export function CommandPalette({ editor }: { readonly editor: Editor }) {
  const [typed, setTyped] = useState('');
  const [active, setActive] = useState(0);
  const field = useRef<HTMLInputElement>(null);
  const list = useRef<HTMLDivElement>(null);
  // The rows stay as they were when the palette opened, because typing must not reorder them.
  const [entries] = useState(() => paletteEntries(editor));
  const ranked =
    typed.trim() === '' ? entries : rankEntries(entries, typed, editor.recentEntries.value);
  const rows = ranked.slice(0, mostRows);

  useLayoutEffect(() => field.current?.focus(), []);
  useEffect(() => {
    list.current?.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: 'nearest' });
  }, [active, typed]);

  const run = (entry: PaletteEntry | undefined): void => {
    if (!entry) return;
    const { dialog, recentEntries } = editor;
    const others = recentEntries.value.filter((id) => id !== entry.id);
    recentEntries.value = [entry.id, ...others].slice(0, mostRecent);
    // A closing dialog returns the focus, so it closes before the entry moves the focus.
    field.current?.closest('dialog')?.close();
    dialog.value = null;
    entry.run();
  };
  const onKey = (event: KeyboardEvent): void => {
    const last = rows.length - 1;
    const moves: Record<string, number> = {
      ArrowDown: active === last ? 0 : active + 1,
      ArrowUp: active === 0 ? last : active - 1,
      PageDown: Math.min(last, active + 8),
      PageUp: Math.max(0, active - 8),
    };
    const move = moves[event.key];
    if (move !== undefined) setActive(Math.max(0, move));
    else if (event.key === 'Enter') run(rows[active]);
    else if (event.key === 'Escape') editor.dialog.value = null; // the browser clears the field first
    else return;
    event.preventDefault();
  };

  return (
    <>
      <input
        ref={field}
        type="search"
        role="combobox"
        list={undefined} // the rows below are the list
        placeholder="Type to search"
        aria-label="Search the commands"
        aria-autocomplete="list"
        aria-expanded="true"
        aria-controls="palette-rows"
        aria-activedescendant={rows.length > 0 ? rowId(active) : undefined}
        onInput={({ currentTarget }) => {
          setTyped(currentTarget.value);
          setActive(0);
        }}
        onKeyDown={onKey}
      />
      <div ref={list} id="palette-rows" class="rows" role="listbox" aria-label="Commands">
        {rows.map((entry, index) => (
          <Row
            key={entry.id}
            entry={entry}
            id={rowId(index)}
            isActive={index === active}
            group={entry.group === rows[index - 1]?.group && typed.trim() === '' ? '' : entry.group}
            onRun={() => run(entry)}
          />
        ))}
      </div>
      <p class="hint" role="status">
        {rows.length === 0 ? 'Nothing fits' : ''}
      </p>
    </>
  );
}

interface RowProperties {
  readonly entry: PaletteEntry;
  readonly id: string;
  readonly isActive: boolean;
  /** Empty if it is that of the row above. */
  readonly group: string;
  readonly onRun: () => void;
}

function Row({ entry: { label, key, isOn }, id, isActive, group, onRun }: RowProperties) {
  return (
    <div
      id={id}
      role="option"
      aria-selected={isActive}
      // The focus stays in the search field.
      onMouseDown={(event) => event.preventDefault()}
      onClick={onRun}
    >
      <span class="group">{group}</span>
      <span>{label}</span>
      {isOn && <span class="on">on</span>}
      {key !== undefined && <kbd>{key}</kbd>}
    </div>
  );
}

function rowId(index: number): string {
  return `palette-row-${index}`;
}
