import { useEffect, useRef } from 'preact/hooks';
import { printable } from '../../core/diagnostics.ts';
import { allSteps } from '../../document/history.ts';
import type { Editor } from '../editor.ts';
import { takeStep } from '../take-step.ts';

/** As many steps are listed before the present one, and after it. */
const [mostBefore, mostAfter] = [60, 30];

/**
 * The steps that were taken, and, faint, those that were undone; a click goes to the scene as it was
 * after one of them.
 */
export function HistoryPanel({ editor }: { readonly editor: Editor }) {
  const { showsHistory } = editor;
  return (
    <details class="section history" open={showsHistory.value}>
      <summary
        onClick={(event) => {
          event.preventDefault();
          showsHistory.value = !showsHistory.value;
        }}
      >
        History
      </summary>
      {showsHistory.value && <Steps editor={editor} />}
    </details>
  );
}

function Steps({ editor }: { readonly editor: Editor }) {
  const list = useRef<HTMLOListElement>(null);
  const history = editor.store.history.value;
  const present = history.past.length;
  const labels = ['Start', ...allSteps(history).map(({ label }) => label)];
  const first = Math.max(0, present - mostBefore);
  const rows = labels.slice(first, present + mostAfter + 1);

  useEffect(() => {
    list.current?.querySelector('[aria-current]')?.scrollIntoView({ block: 'nearest' });
  }, [present]);

  const goTo = (count: number, label: string): string => {
    editor.store.goTo(count);
    return label;
  };
  const onKey = (event: KeyboardEvent): void => {
    const buttons = Array.from(list.current?.querySelectorAll('button') ?? []);
    const at = buttons.indexOf(event.target as HTMLButtonElement);
    const targets: Record<string, number> = {
      ArrowDown: Math.min(at + 1, buttons.length - 1),
      ArrowUp: Math.max(at - 1, 0),
      Home: 0,
      End: buttons.length - 1,
    };
    const target = targets[event.key];
    if (target === undefined) return;
    event.preventDefault();
    buttons[target]?.focus();
  };

  return (
    <ol ref={list} aria-label="Steps" onKeyDown={onKey}>
      {rows.map((label, row) => {
        const count = first + row;
        return (
          <li key={count}>
            <button
              type="button"
              class={count > present ? 'undone' : ''}
              aria-current={count === present ? 'step' : undefined}
              tabIndex={count === present ? 0 : -1}
              onClick={() => takeStep(editor, 'Went to', () => goTo(count, label))}
            >
              {printable(label, 80)}
            </button>
          </li>
        );
      })}
    </ol>
  );
}
