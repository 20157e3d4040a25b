import { useEffect, useState } from 'preact/hooks';
import type { Editor } from '../editor.ts';
import { type Section, type SectionComponent, sections } from '../sections.ts';

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
            <LoadedSection key={section.id} editor={editor} section={section} />
          ) : null,
        )}
    </>
  );
}

function LoadedSection({ editor, section }: { editor: Editor; section: Section }) {
  const [shown, setShown] = useState<{ readonly Component: SectionComponent }>();
  useEffect(() => {
    section.load().then(
      (Component) => setShown({ Component }),
      () => {
        editor.notice.value = 'A part of the page could not be loaded; please reload the page';
      },
    );
  }, [editor, section]);
  return shown ? <shown.Component editor={editor} /> : null;
}
