import { printable } from '../../../core/diagnostics.ts';
import { selectedActor } from '../../../document/selected-actor.ts';
import type { Editor } from '../../editor.ts';
import { runKey } from '../../keys.ts';
import { Sheet } from './sheet.tsx';
import { TransportBar } from './transport-bar.tsx';

/**
 * Plays clips and shows their keys, below the view, while a character has clips. Its height stays
 * the same while a character without clips is selected, so that the view keeps its size.
 */
export function Timeline({ editor }: { readonly editor: Editor }) {
  const { store, session, transport } = editor;
  const actor = selectedActor(store, session);
  if (!actor) return null;
  const index = transport.clipIndex;
  const clip = actor.clips[index];
  const onKey = (event: KeyboardEvent): void => {
    const { target, key } = event;
    // A list and a field handle their own keys, and Space clicks a focused button.
    if (target instanceof HTMLSelectElement) return;
    if (target instanceof HTMLInputElement && target.type !== 'range') return;
    if (key === ' ' && target instanceof HTMLButtonElement) return;
    runKey(editor, event, ['timeline']);
    if (event.defaultPrevented) event.stopPropagation();
  };
  return (
    <section class="timeline" aria-label="Timeline" onKeyDown={onKey}>
      <TransportBar editor={editor} />
      {clip ? (
        <Sheet editor={editor} actor={actor} clip={clip} index={index} />
      ) : (
        <div class="keys-sheet empty">
          <p class="hint">No keys yet: pose {printable(actor.name, 80)} and press k</p>
        </div>
      )}
    </section>
  );
}
