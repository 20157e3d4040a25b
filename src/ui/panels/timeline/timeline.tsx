import { printable } from '../../../core/diagnostics.ts';
import { selectedActor } from '../../../document/selected-actor.ts';
import type { Editor } from '../../editor.ts';
import { runKey } from '../../keys.ts';
import { ClipCurves } from './clip-curves.tsx';
import { TransportBar } from './transport-bar.tsx';

/**
 * Plays clips and shows their curves, below the view, while a character has clips. Its height stays
 * the same while a character without clips is selected, so that the view keeps its size.
 */
export function Timeline({ editor }: { readonly editor: Editor }) {
  const { store, session, transport } = editor;
  const state = selectedActor(store, session);
  const { clip } = transport;
  if (!state) return null;
  const onKey = (event: KeyboardEvent): void => {
    const { target, key } = event;
    // A list handles its own keys, and Space clicks a focused button.
    if (target instanceof HTMLSelectElement) return;
    if (key === ' ' && target instanceof HTMLButtonElement) return;
    runKey(editor, event, ['timeline']);
    if (event.defaultPrevented) event.stopPropagation();
  };
  return (
    <section class="timeline" aria-label="Timeline" onKeyDown={onKey}>
      <TransportBar editor={editor} />
      {clip ? (
        <ClipCurves
          editor={editor}
          clip={clip}
          skeleton={state.character.skeleton}
          time={session.clipTime.value}
        />
      ) : (
        <figure class="curves">
          <svg aria-hidden="true" />
          <figcaption>{printable(state.name, 80)} has no clips</figcaption>
        </figure>
      )}
    </section>
  );
}
