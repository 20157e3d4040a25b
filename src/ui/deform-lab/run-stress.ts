import type { Editor } from '../editor.ts';
import { measuresOpen } from './measures-open.ts';
import { stressLabOf } from './stress-lab.ts';

/** Runs the stress suite on the selected character and shows it in the Deform tab. */
export async function runStress(editor: Editor): Promise<void> {
  const lab = stressLabOf(editor);
  measuresOpen.stress.value = true;
  editor.tab.value = 'deform';
  await lab.run();
}
