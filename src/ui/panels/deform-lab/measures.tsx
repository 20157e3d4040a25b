import { loadPart } from '../../../core/failure.ts';
import { measuresOpen } from '../../deform-lab/measures-open.ts';
import type { Editor } from '../../editor.ts';
import type { SectionComponent } from '../../sections.ts';
import { LabPanel } from '../lab-panel.tsx';

/** The panels that measure what methods do: over the range of a joint, and in many poses. */
export function Measures({ editor }: { readonly editor: Editor }) {
  return (
    <>
      <LabPanel
        editor={editor}
        class="sweep"
        title="Sweep of a joint"
        isOpen={measuresOpen.sweep}
        load={loadSweep}
      />
      <LabPanel
        editor={editor}
        class="stress"
        title="Stress suite"
        isOpen={measuresOpen.stress}
        load={loadStress}
      />
    </>
  );
}

async function loadSweep(): Promise<SectionComponent> {
  return (await loadPart(import('./sweep.tsx'))).Sweep;
}

async function loadStress(): Promise<SectionComponent> {
  return (await loadPart(import('./stress.tsx'))).Stress;
}
