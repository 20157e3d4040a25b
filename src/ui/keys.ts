import type { Editor } from './editor.ts';
import { everywhere, type KeyBinding, withCommand } from './keymap.ts';

/** What has keys of its own; only those with Ctrl or Cmd act there. */
const ownKeys = 'input, select, textarea, dialog, [role="tree"], [role="slider"]';

/** Runs the first binding that a key press matches. */
export function listenToKeys(editor: Editor): void {
  // lil-gui keeps key presses to itself, so that those with Ctrl or Cmd are caught on their way in.
  window.addEventListener('keydown', (event) => run(withCommand, event, editor), true);
  window.addEventListener('keydown', (event) => {
    if (!event.defaultPrevented && !hasOwnKeys(event)) run(everywhere, event, editor);
  });
}

function run(bindings: readonly KeyBinding[], event: KeyboardEvent, editor: Editor): void {
  const binding = bindings.find((each) => matches(each, event));
  if (!binding || (isLetter(binding) && !editor.letterKeys.value)) return;
  event.preventDefault();
  binding.run(editor);
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
  if (target.closest(ownKeys)) return true;
  return (key === ' ' || key === 'Enter') && target.closest('button, summary, a') !== null;
}
