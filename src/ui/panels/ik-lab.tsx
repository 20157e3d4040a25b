import { loadPart } from '../../core/failure.ts';
import type { Editor } from '../editor.ts';
import type { SectionComponent } from '../sections.ts';
import { Loaded } from './loaded.tsx';

/** The head of the IK lab; what is in it is loaded when it is opened. */
export function IkLabPanel({ editor }: { readonly editor: Editor }) {
  const { showIkLab } = editor.session;
  return (
    <details class="ik-lab" open={showIkLab.value}>
      <summary
        onClick={(event) => {
          event.preventDefault();
          showIkLab.value = !showIkLab.value;
        }}
      >
        IK lab
      </summary>
      {showIkLab.value && <Loaded editor={editor} load={loadLab} />}
    </details>
  );
}

async function loadLab(): Promise<SectionComponent> {
  return (await loadPart(import('./ik-lab/load-lab.tsx'))).loadLab();
}
