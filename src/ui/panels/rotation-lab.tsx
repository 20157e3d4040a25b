import { loadPart } from '../../core/failure.ts';
import type { Editor } from '../editor.ts';
import type { SectionComponent } from '../sections.ts';
import { LabPanel } from './lab-panel.tsx';

export function RotationLabPanel({ editor }: { readonly editor: Editor }) {
  return (
    <LabPanel
      editor={editor}
      class="rotation-lab"
      title="Rotation lab"
      isOpen={editor.showsRotationLab}
      load={loadLab}
    />
  );
}

async function loadLab(): Promise<SectionComponent> {
  return (await loadPart(import('./rotation-lab/lab.tsx'))).Lab;
}
