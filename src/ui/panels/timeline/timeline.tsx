import { useEffect, useRef } from 'preact/hooks';
import { selectedActor } from '../../../document/selected-actor.ts';
import type { Editor } from '../../editor.ts';
import { runKey } from '../../keys.ts';
import { followKeySelection } from '../../timeline/follow-selection.ts';
import { copiedKeys } from '../../timeline/timeline-state.ts';
import { HeightEdge } from './height-edge.tsx';
import { Sheet } from './sheet.tsx';
import { NoKeys } from './no-keys.tsx';
import { TransportBar } from './transport-bar.tsx';

/**
 * Plays clips and shows their keys, below the view, while a character has clips. Its height stays
 * the same while a character without clips is selected, so that the view keeps its size.
 */
export function Timeline({ editor }: { readonly editor: Editor }) {
  const { store, session, transport } = editor;
  const section = useRef<HTMLElement>(null);
  useEffect(() => followKeySelection(editor), [editor]);
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
    if (isOfPoses(event)) return;
    runKey(editor, event, ['timeline']);
    if (event.defaultPrevented) event.stopPropagation();
  };
  // Without keys to copy or paste, these are for poses and files here too.
  const isOfPoses = ({ key, ctrlKey, metaKey }: KeyboardEvent): boolean => {
    if (!ctrlKey && !metaKey) return false;
    const letter = key.toLowerCase();
    if (letter === 'v') return copiedKeys.value === null;
    return (letter === 'c' || letter === 'x') && session.selectedKeys.value.size === 0;
  };
  return (
    <section class="timeline" aria-label="Timeline" ref={section} onKeyDown={onKey}>
      <HeightEdge timeline={section} />
      <TransportBar editor={editor} />
      {clip ? (
        <Sheet editor={editor} actor={actor} clip={clip} index={index} />
      ) : (
        <div class="keys-sheet empty">
          <NoKeys actor={actor} />
        </div>
      )}
    </section>
  );
}
