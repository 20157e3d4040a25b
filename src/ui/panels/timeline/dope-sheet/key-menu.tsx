import type { RefObject } from 'preact';
import type { Extrapolation } from '../../../../core/motion/clip-parts.ts';
import type { CommandId } from '../../../commands/registry.ts';
import {
  commonExtrapolation,
  continueCurves,
  continuedCurves,
  type CurveEnd,
  extrapolations,
} from '../../../curve-editor/continue-curves.ts';
import type { Editor } from '../../../editor.ts';
import { CommandButton } from '../../command-button.tsx';

interface KeyMenuProperties {
  readonly editor: Editor;
  readonly element: RefObject<HTMLDivElement | null>;
}

/** What the menu offers for keys, in groups. */
const groups: readonly (readonly CommandId[])[] = [
  [
    ...(['tangents-auto', 'tangents-smooth', 'tangents-linear', 'tangents-flat'] as const),
    ...(['tangents-fixed', 'tangents-stepped', 'tangents-tcb'] as const),
  ],
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
        <div key={commands[0]} role="group" class={commands.length > 4 ? 'in-fours' : 'in-twos'}>
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
      {(['before', 'after'] as const).map((end) => (
        <CurveEnds key={end} editor={editor} end={end} onRun={close} />
      ))}
    </div>
  );
}

interface CurveEndsProperties {
  readonly editor: Editor;
  readonly end: CurveEnd;
  readonly onRun: () => void;
}

/** How the curves of the selected keys go on at one end. */
function CurveEnds({ editor, end, onRun }: CurveEndsProperties) {
  const present = commonExtrapolation(editor, end);
  const isNone = continuedCurves(editor).length === 0;
  const label = end === 'before' ? 'Before the first key' : 'After the last key';
  return (
    <div role="group" aria-label={label} class="in-threes">
      <span aria-hidden="true">{label}</span>
      {Object.entries(extrapolations).map(([rule, name]) => (
        <button
          key={rule}
          type="button"
          role="menuitemradio"
          aria-checked={rule === present}
          disabled={isNone}
          onClick={() => {
            onRun();
            continueCurves(editor, end, rule as Extrapolation);
          }}
        >
          {name}
        </button>
      ))}
    </div>
  );
}

/** So long after a finger has left, the browser may close what it opened, in milliseconds. */
const closingTime = 300;

/**
 * Opens the menu at a place of the page.
 *
 * @param isHeld whether a finger that opens it is still down: when it leaves, the browser closes the
 * menu, as if that pressed beside it, and it is opened again, unless it was used already
 */
export function openMenuOfKeys(menu: HTMLElement, x: number, y: number, isHeld: boolean): void {
  openKeyMenu(menu, x, y);
  if (!isHeld) return;
  const onToggle = ({ newState }: ToggleEvent): void => {
    if (newState === 'closed' && menu.isConnected) openKeyMenu(menu, x, y);
  };
  menu.addEventListener('toggle', onToggle);
  const leaveClosed = (): void => menu.removeEventListener('toggle', onToggle);
  const end = (): void => {
    window.setTimeout(leaveClosed, closingTime);
  };
  for (const type of ['pointerdown', 'keydown'])
    menu.addEventListener(type, leaveClosed, { once: true });
  for (const type of ['pointerup', 'pointercancel'])
    window.addEventListener(type, end, { once: true, capture: true });
}

/** Opens the menu wholly inside of the page. */
function openKeyMenu(menu: HTMLElement, x: number, y: number): void {
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
    ArrowRight: at + 1,
    ArrowLeft: at - 1,
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
