import type { Editor } from '../editor.ts';
import { type Section, sections } from '../sections.ts';
import { Loaded } from './loaded.tsx';

interface SectionsProperties {
  readonly editor: Editor;
  readonly place: Section['place'];
}

/** The sections of a place that have something to show. */
export function Sections({ editor, place }: SectionsProperties) {
  return (
    <>
      {sections
        .filter((section) => section.place === place)
        .map((section) =>
          section.when(editor) ? (
            <Loaded key={section.id} editor={editor} load={section.load} />
          ) : null,
        )}
    </>
  );
}
