import { useEffect, useState } from 'preact/hooks';
import { attempt } from '../attempt.ts';
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
    attempt(
      editor,
      section.load().then((Component) => setShown({ Component })),
    );
  }, [editor, section]);
  return shown ? <shown.Component editor={editor} /> : null;
}
