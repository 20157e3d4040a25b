import { useRef } from 'preact/hooks';
import type { Editor } from '../editor.ts';
import { type Section, sections } from '../sections.ts';
import { Loaded } from './loaded.tsx';

interface SectionsProperties {
  readonly editor: Editor;
  readonly place: Section['place'];
}

/**
 * The sections of a place that have something to show. A section of another tab is only hidden, so
 * that what the user folded and typed in it stays.
 */
export function Sections({ editor, place }: SectionsProperties) {
  const seen = useRef(new Set<string>());
  const tab = editor.tab.value;
  return (
    <>
      {sections
        .filter((section) => section.place === place)
        .map(({ id, tabs, when, load }) => {
          const hasContent = when?.(editor) ?? true;
          const isOpen = tabs?.includes(tab) ?? true;
          if (!hasContent) seen.current.delete(id);
          else if (isOpen) seen.current.add(id);
          return seen.current.has(id) ? (
            <div key={id} data-section={id} hidden={!isOpen}>
              <Loaded editor={editor} load={load} />
            </div>
          ) : null;
        })}
    </>
  );
}
