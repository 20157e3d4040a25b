import { loadPart } from '../../core/failure.ts';
import { commandOf } from '../commands/registry.ts';
import { runCommand } from '../commands/command.ts';
import type { Editor } from '../editor.ts';
import type { SectionComponent } from '../sections.ts';
import { Loaded } from './loaded.tsx';

/** The head of the deformation lab, which opens with a comparison and closes with it. */
export function DeformLabPanel({ editor }: { readonly editor: Editor }) {
  const isOpen = editor.session.comparison.value !== null;
  return (
    <details class="section deform-lab" open={isOpen}>
      <summary
        onClick={(event) => {
          event.preventDefault();
          runCommand(commandOf('compare'), editor);
        }}
      >
        Deformation lab
      </summary>
      {isOpen && <Loaded editor={editor} load={loadLab} />}
    </details>
  );
}

async function loadLab(): Promise<SectionComponent> {
  return (await loadPart(import('./deform-lab/lab.tsx'))).Lab;
}
