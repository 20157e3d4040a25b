import { useEffect, useState } from 'preact/hooks';
import { attempt } from '../attempt.ts';
import type { Editor } from '../editor.ts';
import type { SectionComponent } from '../sections.ts';

interface LoadedProperties {
  readonly editor: Editor;
  readonly load: () => Promise<SectionComponent>;
}

/** A component that is loaded when it is first shown. */
export function Loaded({ editor, load }: LoadedProperties) {
  const [shown, setShown] = useState<{ readonly Component: SectionComponent }>();
  useEffect(() => {
    attempt(
      editor,
      load().then((Component) => setShown({ Component })),
    );
  }, [editor, load]);
  return shown ? <shown.Component editor={editor} /> : null;
}
