import type { GUI } from 'lil-gui';
import { type BoneDrag, plainLook } from '../../document/actor-look.ts';
import { setLook } from '../../document/look-edits.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Editor } from '../editor.ts';
import { watch } from '../watch.ts';
import { addCommandRow } from './command-row.ts';
import { field } from './signal-field.ts';

/** Adds controls for what dragging a limb does. */
export function addBoneFolder(gui: GUI, editor: Editor): void {
  const { store, session } = editor;
  const folder = gui.addFolder('Dragging').close();
  const ways: Record<string, BoneDrag> = {
    'follows the pointer': 'follow',
    'as in CS354': 'course',
  };
  const dragging = field(
    () => selectedActor(store, session)?.look.dragging ?? plainLook.dragging,
    (way) => {
      const actor = selectedActor(store, session);
      if (actor) store.dispatch(setLook(actor.id, { dragging: way }, 'Change how dragging turns'));
    },
  );
  const row = folder.add(dragging, 'value', ways).name('Dragging');
  addCommandRow(folder, editor, 'bone-mode');
  watch([store.scene, session.selectedActorId], () => void row.updateDisplay());
}
