import { loadPart } from '../../core/failure.ts';
import { runCommand } from '../commands/command.ts';
import { commandOf } from '../commands/registry.ts';
import type { Editor } from '../editor.ts';
import type { SectionComponent } from '../sections.ts';
import { Loaded } from './loaded.tsx';

/** The head of the vertex inspector, which is open while a vertex is inspected. */
export function VertexInspector({ editor }: { readonly editor: Editor }) {
  const isOpen = editor.session.inspectedPoint.value !== null;
  return (
    <details class="section vertex-inspector" open={isOpen}>
      <summary
        onClick={(event) => {
          event.preventDefault();
          runCommand(commandOf('inspect-vertex'), editor);
        }}
      >
        Vertex inspector
      </summary>
      {isOpen && <Loaded editor={editor} load={loadInspector} />}
    </details>
  );
}

async function loadInspector(): Promise<SectionComponent> {
  return (await loadPart(import('./vertex-inspector/inspector.tsx'))).Inspector;
}
