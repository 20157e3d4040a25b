import { loadPart } from '../../core/failure.ts';
import type { Editor } from '../editor.ts';
import type { SectionComponent } from '../sections.ts';
import { LabPanel } from './lab-panel.tsx';

export function IkLabPanel({ editor }: { readonly editor: Editor }) {
  const { showIkLab } = editor.session;
  return (
    <LabPanel editor={editor} class="ik-lab" title="IK lab" isOpen={showIkLab} load={loadLab} />
  );
}

async function loadLab(): Promise<SectionComponent> {
  return (await loadPart(import('./ik-lab/load-lab.tsx'))).loadLab();
}
