import type { Editor } from './editor.ts';
import { everywhere, type KeyBinding, withCommand } from './keymap.ts';

/** Runs the first binding that a key press matches; text fields keep their own keys. */
export function listenToKeys(editor: Editor): void {
  window.addEventListener('keydown', (event) => {
    const bindings = isTextField(event.target) ? [] : everywhere;
    const binding = [...withCommand, ...bindings].find((each) => matches(each, event));
    if (!binding || event.defaultPrevented || isOperated(event)) return;
    event.preventDefault();
    binding.run(editor);
  });
}

function matches({ key, command = false, shift }: KeyBinding, event: KeyboardEvent): boolean {
  const pressed = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (pressed !== key || event.altKey) return false;
  if (command !== (event.ctrlKey || event.metaKey)) return false;
  // "?" needs Shift on many keyboards; with a command key Shift tells two bindings apart.
  return !command || (shift ?? false) === event.shiftKey;
}

function isTextField(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLTextAreaElement ||
    target instanceof HTMLSelectElement ||
    (target instanceof HTMLInputElement && !/^(checkbox|radio|button)$/.test(target.type))
  );
}

/** Space and Enter on a button press it. */
function isOperated({ key, target }: KeyboardEvent): boolean {
  if (!(target instanceof HTMLElement)) return false;
  return (key === ' ' || key === 'Enter') && target.matches('button, summary, a, input');
}
