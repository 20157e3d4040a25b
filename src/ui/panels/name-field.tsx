import { useEffect, useRef } from 'preact/hooks';
import { printable } from '../../core/diagnostics.ts';
import { renameActor } from '../../document/edits.ts';
import type { Actor } from '../../document/scene.ts';
import type { Editor } from '../editor.ts';

const longestName = 80;

/** The field in which an actor is renamed: Enter or leaving it keeps the name, Esc does not. */
export function NameField({ editor, actor }: { readonly editor: Editor; readonly actor: Actor }) {
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => field.current?.select(), []);
  const close = (): void => {
    const row = field.current?.closest('li');
    const hadFocus = document.activeElement === field.current;
    editor.renaming.value = null;
    // The keyboard goes on from the name, once its button is back.
    if (hadFocus) setTimeout(() => row?.querySelector<HTMLElement>('.name')?.focus());
  };
  const keep = (text: string): void => {
    // Leaving the field after Esc or Enter says nothing more.
    if (editor.renaming.peek() !== actor.id) return;
    close();
    const name = printable(text.trim(), longestName);
    if (name === '') editor.notice.value = `A name needs a letter, so ${actor.name} keeps its own`;
    else if (name !== actor.name) {
      editor.store.dispatch(renameActor(actor, name));
      editor.notice.value = `${actor.name} is now called ${name}`;
    }
  };
  return (
    <input
      ref={field}
      class="name"
      aria-label={`Name of ${actor.name}`}
      value={actor.name}
      maxLength={longestName}
      autocomplete="off"
      spellcheck={false}
      onBlur={({ currentTarget }) => keep(currentTarget.value)}
      onKeyDown={({ key, isComposing, currentTarget }) => {
        // Enter and Esc first belong to an input method.
        if (isComposing) return;
        if (key === 'Enter') keep(currentTarget.value);
        if (key === 'Escape') close();
      }}
    />
  );
}
