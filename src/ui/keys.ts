import type { Editor } from './editor.ts';
import { everywhere, type KeyBinding, withCommand } from './keymap.ts';

/** What has keys of its own: there only those with Ctrl or Cmd act. */
const ownKeys = 'input, select, textarea, dialog, [role="tree"], [role="slider"]';

/** Runs the first binding that a key press matches. */
export function listenToKeys(editor: Editor): void {
  const onKey = (event: KeyboardEvent): void => {
    if (event.defaultPrevented) return;
    const bindings = hasOwnKeys(event) ? withCommand : [...withCommand, ...everywhere];
    const binding = bindings.find((each) => matches(each, event));
    if (!binding || (isLetter(binding) && !editor.letterKeys.value)) return;
    event.preventDefault();
    binding.run(editor);
  };
  window.addEventListener('keydown', onKey);
  // lil-gui lets no key press out of its rows, where undo must act too: they are met on the way in.
  window.addEventListener('keydown', (event) => isInRow(event.target) && onKey(event), true);
}

function isInRow(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest('.lil-controller') !== null;
}

function matches({ key, command = false, shift }: KeyBinding, event: KeyboardEvent): boolean {
  const pressed = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (pressed !== key || event.altKey) return false;
  if (command !== (event.ctrlKey || event.metaKey)) return false;
  // "?" needs Shift on many keyboards; with a command key Shift tells two bindings apart.
  return !command || (shift ?? false) === event.shiftKey;
}

function isLetter({ key, command }: KeyBinding): boolean {
  return key.length === 1 && key !== ' ' && !command;
}

/** Space and Enter belong to a button that has the focus, all keys to fields and lists. */
function hasOwnKeys({ key, target }: KeyboardEvent): boolean {
  if (!(target instanceof Element)) return false;
  // A slider is dragged with the pointer too: Escape takes that back.
  if (target.closest(ownKeys)) return key !== 'Escape' || !target.matches('[role="slider"]');
  return (key === ' ' || key === 'Enter') && target.closest('button, summary, a') !== null;
}
