import { type ContextId, type KeyPress, runCommand } from './commands/command.ts';
import { contexts, keysOf } from './commands/contexts.ts';
import type { Editor } from './editor.ts';

/** What a list has while a press brought the focus there, so that letters act as in the view. */
export const pressedAttribute = 'data-pressed';

/** Elements with keys of their own; there, only keys with Ctrl or Cmd apply. */
const ownKeys = `input, select, textarea, dialog, [role="tree"]:not([${pressedAttribute}]), [role="slider"]`;

/** Runs a command for each key press that matches one of its keys. */
export function listenToKeys(editor: Editor): void {
  const onKey = (event: KeyboardEvent): void => {
    const active = contexts.filter((context) => context.isActive(editor));
    const heard = hasOwnKeys(event) ? active.filter(({ id }) => isHeardIn(event, id)) : active;
    runKey(
      editor,
      event,
      heard.map(({ id }) => id),
    );
  };
  window.addEventListener('keydown', onKey);
  // lil-gui stops key events inside its rows, but undo must work there too, so they are handled in
  // the capture phase.
  window.addEventListener('keydown', (event) => isInRow(event.target) && onKey(event), true);
}

/** Runs the first command, in the order of the contexts, whose key matches. */
export function runKey(editor: Editor, event: KeyboardEvent, ids: readonly ContextId[]): void {
  if (event.defaultPrevented) return;
  const binding = ids.flatMap(keysOf).find(({ press }) => matches(press, event));
  if (
    !binding ||
    binding.command.byBrowser ||
    (isLetter(binding.press) && !editor.letterKeys.value)
  )
    return;
  event.preventDefault();
  runCommand(binding.command, editor);
}

function isInRow(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest('.lil-controller') !== null;
}

function matches(
  { key, control = false, alt = false, shift }: KeyPress,
  event: KeyboardEvent,
): boolean {
  const pressed = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (pressed !== key || alt !== event.altKey) return false;
  if (control !== (event.ctrlKey || event.metaKey)) return false;
  // "?" needs Shift on many keyboards, so Shift is compared only if a key names it, or with Ctrl or
  // Cmd.
  return shift === undefined ? !control || !event.shiftKey : shift === event.shiftKey;
}

function isLetter({ key, control }: KeyPress): boolean {
  return key.length === 1 && key !== ' ' && !control;
}

/** Whether the keys of a context also act in an element that has keys of its own. */
function isHeardIn({ target }: KeyboardEvent, id: ContextId): boolean {
  const isInTree = target instanceof Element && target.closest('[role="tree"]') !== null;
  return id === 'control' || (id === 'turning' && isInTree);
}

/** Space and Enter belong to a focused button, and all keys to text fields and lists. */
function hasOwnKeys({ key, target }: KeyboardEvent): boolean {
  if (!(target instanceof Element)) return false;
  // A slider is also dragged with the pointer, and Escape cancels that drag; in the list of joints it
  // narrows the selection.
  const leavesEscape = '[role="slider"], [role="treeitem"]';
  if (target.closest(ownKeys)) return key !== 'Escape' || !target.matches(leavesEscape);
  return (key === ' ' || key === 'Enter') && target.closest('button, summary, a') !== null;
}
