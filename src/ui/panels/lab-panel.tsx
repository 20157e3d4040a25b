import type { Signal } from '@preact/signals-core';
import type { Editor } from '../editor.ts';
import type { SectionComponent } from '../sections.ts';
import { Loaded } from './loaded.tsx';

interface LabPanelProperties {
  readonly editor: Editor;
  /** The class by which its style and commands find it. */
  readonly class: string;
  readonly title: string;
  readonly isOpen: Signal<boolean>;
  readonly load: () => Promise<SectionComponent>;
}

/** The head of a lab; what is in it is loaded when it is opened. */
export function LabPanel({ editor, class: name, title, isOpen, load }: LabPanelProperties) {
  return (
    <details class={`section ${name}`} open={isOpen.value}>
      <summary
        onClick={(event) => {
          event.preventDefault();
          isOpen.value = !isOpen.value;
        }}
      >
        {title}
      </summary>
      {isOpen.value && <Loaded editor={editor} load={load} />}
    </details>
  );
}
