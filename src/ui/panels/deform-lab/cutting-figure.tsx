import { loadPart } from '../../../core/failure.ts';
import { cuttingSettings } from '../../deform-lab/cutting-settings.ts';
import type { Editor } from '../../editor.ts';
import type { SectionComponent } from '../../sections.ts';
import { LabPanel } from '../lab-panel.tsx';

export function CuttingFigurePanel({ editor }: { readonly editor: Editor }) {
  return (
    <LabPanel
      editor={editor}
      class="cutting-figure"
      title="Cutting figure"
      isOpen={cuttingSettings(editor.session).isOpen}
      load={loadFigure}
    />
  );
}

async function loadFigure(): Promise<SectionComponent> {
  return (await loadPart(import('./cutting-figure-lab.tsx'))).CuttingFigureLab;
}
