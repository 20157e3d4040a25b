import type { RefObject } from 'preact';
import type { CommandId } from '../../../commands/registry.ts';
import type { Editor } from '../../../editor.ts';
import { CommandButton } from '../../command-button.tsx';

interface KeyMenuProperties {
  readonly editor: Editor;
  readonly element: RefObject<HTMLDivElement | null>;
}

/** What the menu offers for keys, in groups. */
const groups: readonly (readonly CommandId[])[] = [
  ['tangents-auto', 'tangents-smooth', 'tangents-linear', 'tangents-flat'],
  ['tangents-fixed', 'tangents-stepped', 'tangents-tcb'],
  ['copy-keys', 'cut-keys', 'paste-keys', 'paste-keys-reversed'],
  ['duplicate-keys', 'remove-keys'],
  ['frame-keys', 'work-range-keys'],
];

/** The menu of the selected keys, which the right button or a long press opens over the rows. */
export function KeyMenu({ editor, element }: KeyMenuProperties) {
  const close = (): void => element.current!.hidePopover();
  return (
    <div
      ref={element}
      popover="auto"
      role="menu"
      aria-label="Selected keys"
      class="menu key-menu"
      onKeyDown={(event) => walkItems(element.current!, event)}
    >
      {groups.map((commands) => (
        <div key={commands[0]} role="group">
          {commands.map((command) => (
            <CommandButton
              key={command}
              editor={editor}
              command={command}
              role="menuitem"
              onRun={close}
            />
          ))}
        </div>
      ))}
    </div>
  );
}

/** Opens the menu at a place of the page, wholly inside of it. */
export function openKeyMenu(menu: HTMLElement, x: number, y: number): void {
  menu.showPopover();
  const left = Math.max(4, Math.min(x, window.innerWidth - menu.offsetWidth - 4));
  const top = Math.max(4, Math.min(y, window.innerHeight - menu.offsetHeight - 4));
  Object.assign(menu.style, { left: `${left}px`, top: `${top}px` });
  menu.querySelector<HTMLElement>('button:not(:disabled)')?.focus();
}

function walkItems(menu: HTMLElement, event: KeyboardEvent): void {
  const items = [...menu.querySelectorAll<HTMLElement>('button:not(:disabled)')];
  const at = items.indexOf(document.activeElement as HTMLElement);
  const targets: Readonly<Record<string, number>> = {
    ArrowDown: at + 1,
    ArrowUp: at - 1,
    Home: 0,
    End: -1,
  };
  const target = targets[event.key];
  // Other keys are the timeline's no more while the menu is open.
  event.stopPropagation();
  if (target === undefined) return;
  event.preventDefault();
  items.at(target % items.length)?.focus();
}
