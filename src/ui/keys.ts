import type { Editor } from './editor.ts';
import { contexts, type KeyBinding, withCommand } from './keymap.ts';

/** What has keys of its own: there only those with Ctrl or Cmd act. */
const ownKeys = 'input, select, textarea, dialog, [role="tree"], [role="slider"]';

/** Runs the first binding that a key press matches. */
export function listenToKeys(editor: Editor): void {
  const onKey = (event: KeyboardEvent): void => {
    if (event.defaultPrevented) return;
    const active = contexts.filter((context) => context.isActive(editor));
    const letters = hasOwnKeys(event) ? [] : active.flatMap(({ keys }) => keys);
    const binding = [...withCommand, ...letters].find((each) => matches(each, event));
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
  // "?" needs Shift on many keyboards; where a binding says so, and with a command key, it counts.
  return shift === true ? event.shiftKey : !command || !event.shiftKey;
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
