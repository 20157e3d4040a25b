import type { Editor } from '../editor.ts';
import { tabs } from '../tabs.ts';

interface TabListProperties {
  readonly editor: Editor;
  /** Whether its sheet opens and closes by presses on the tab, as on a phone. */
  readonly folds?: boolean;
}

/** The tasks of the page, of which one is open. */
export function TabList({ editor, folds = false }: TabListProperties) {
  const { tab, drawer } = editor;
  const onKeyDown = (event: KeyboardEvent): void => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const next = tabs.at((tabs.findIndex(({ id }) => id === tab.value) + step) % tabs.length)!;
    tab.value = next.id;
    const list = event.currentTarget as HTMLElement;
    list.querySelector<HTMLElement>(`[data-tab="${next.id}"]`)?.focus();
  };
  return (
    <div role="tablist" aria-label="Tasks" onKeyDown={onKeyDown}>
      {tabs.map(({ id, label, isTimeline = false }) => {
        const isChosen = tab.value === id;
        const hasSheet = isChosen && drawer.value === 'right';
        const isOpen = isChosen && (!folds || hasSheet || (isTimeline && drawer.value === null));
        return (
          <button
            key={id}
            type="button"
            role="tab"
            data-tab={id}
            aria-selected={isOpen}
            aria-controls="inspector"
            tabIndex={isChosen ? 0 : -1}
            onClick={() => {
              tab.value = id;
              if (folds) drawer.value = hasSheet || (isTimeline && !isOpen) ? null : 'right';
            }}
          >
            {label}
          </button>
        );
      })}
    </div>
  );
}
