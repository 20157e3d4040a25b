import type { Editor } from '../editor.ts';
import { toggleLab } from '../toggle-lab.ts';
import { measuresOpen } from './measures-open.ts';

/** Opens or closes a panel that measures methods. */
export function toggleMeasures(editor: Editor, panel: keyof typeof measuresOpen): Promise<void> {
  return toggleLab(editor, measuresOpen[panel], 'deform', panel);
}
