import { type ContextId, type KeyPress, runCommand } from './commands/command.ts';
import { contexts, keysOf } from './commands/contexts.ts';
import type { Editor } from './editor.ts';

/** What has keys of its own: there only those with Ctrl or Cmd act. */
const ownKeys = 'input, select, textarea, dialog, [role="tree"], [role="slider"]';

/** Runs the command of the first key that a press matches. */
export function listenToKeys(editor: Editor): void {
  const onKey = (event: KeyboardEvent): void => {
    const active = contexts.filter((context) => context.isActive(editor));
    const heard = hasOwnKeys(event) ? active.filter(({ id }) => id === 'control') : active;
    runKey(
      editor,
      event,
      heard.map(({ id }) => id),
    );
  };
  window.addEventListener('keydown', onKey);
  // lil-gui lets no key press out of its rows, where undo must act too: they are met on the way in.
  window.addEventListener('keydown', (event) => isInRow(event.target) && onKey(event), true);
}

/** Runs the first command of the contexts, in their order, that has the key. */
export function runKey(editor: Editor, event: KeyboardEvent, ids: readonly ContextId[]): void {
  if (event.defaultPrevented) return;
  const binding = ids.flatMap(keysOf).find(({ press }) => matches(press, event));
  if (!binding || (isLetter(binding.press) && !editor.letterKeys.value)) return;
  event.preventDefault();
  runCommand(binding.command, editor);
}

function isInRow(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest('.lil-controller') !== null;
}

function matches({ key, control = false, shift }: KeyPress, event: KeyboardEvent): boolean {
  const pressed = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (pressed !== key || event.altKey) return false;
  if (control !== (event.ctrlKey || event.metaKey)) return false;
  // "?" needs Shift on many keyboards; where a key says so, and with Ctrl or Cmd, it counts.
  return shift === true ? event.shiftKey : !control || !event.shiftKey;
}

function isLetter({ key, control }: KeyPress): boolean {
  return key.length === 1 && key !== ' ' && !control;
}

/** Space and Enter belong to a button that has the focus, all keys to fields and lists. */
function hasOwnKeys({ key, target }: KeyboardEvent): boolean {
  if (!(target instanceof Element)) return false;
  // A slider is dragged with the pointer too: Escape takes that back.
  if (target.closest(ownKeys)) return key !== 'Escape' || !target.matches('[role="slider"]');
  return (key === ' ' || key === 'Enter') && target.closest('button, summary, a') !== null;
}
