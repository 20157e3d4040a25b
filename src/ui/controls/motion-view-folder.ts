import { effect, type Signal } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import { motionViewOf } from '../../document/motion-view.ts';
import { boundClip } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { selectedJoints } from '../../document/selected-joints.ts';
import type { Editor } from '../editor.ts';
import { keptTrailNames } from '../trail-joints.ts';
import { addCommandRow } from './command-row.ts';
import { addNote } from './note.ts';
import { field } from './signal-field.ts';

/** How many frames about the present a trail shows if it does not show all. */
const someFrames = 12;

/** Adds what the view shows of motion: ghosts and trails. Returns what ends its effects. */
export function addMotionViewFolder(gui: GUI, editor: Editor): () => void {
  const { store, session } = editor;
  const { ghosts, trails, trailJoints } = motionViewOf(session);
  const folder = gui.addFolder('Motion').close();
  addCommandRow(folder, editor, 'ghosts');
  const ghostRows = [
    folder.add(partOf(ghosts, 'before'), 'value', 0, 10, 1).name('Ghosts before'),
    folder.add(partOf(ghosts, 'after'), 'value', 0, 10, 1).name('Ghosts after'),
    folder
      .add(partOf(ghosts, 'at'), 'value', { 'Every few frames': 'frames', 'At keys': 'keys' })
      .name('Stand'),
  ];
  const apart = folder.add(partOf(ghosts, 'frames'), 'value', 1, 30, 1).name('Frames apart');
  ghostRows.push(
    folder.add(partOf(ghosts, 'fade'), 'value', 0, 1, 0.05).name('Fade'),
    folder.add(partOf(ghosts, 'whilePlaying'), 'value').name('Ghosts in play'),
  );
  addCommandRow(folder, editor, 'trails');
  const range = field(
    () => trails.value.frames === null,
    (all) => (trails.value = { ...trails.value, frames: all ? null : someFrames }),
  );
  const frames = field(
    () => trails.value.frames ?? someFrames,
    (count) => (trails.value = { ...trails.value, frames: count }),
  );
  const trailRows = [
    folder
      .add(partOf(trails, 'point'), 'value', { 'End of the limb': 'end', Joint: 'joint' })
      .name('Trail of'),
    folder.add(range, 'value').name('Over the whole clip'),
  ];
  const around = folder.add(frames, 'value', 1, 120, 1).name('Frames on each side');
  addCommandRow(folder, editor, 'show-trail');
  const note = addNote(folder, '');
  return effect(() => {
    const [showsGhosts, showsTrails] = [ghosts.value.isOn, trails.value.isOn];
    for (const row of ghostRows) row.show(showsGhosts).updateDisplay();
    apart.show(showsGhosts && ghosts.value.at === 'frames').updateDisplay();
    for (const row of trailRows) row.show(showsTrails).updateDisplay();
    around.show(showsTrails && trails.value.frames !== null).updateDisplay();
    const actor = selectedActor(store, session);
    note.textContent = noteOf(actor !== undefined && boundClip(actor) !== undefined);
  });

  function noteOf(hasClip: boolean): string {
    if (!hasClip) return 'Play a clip, or make one, to see its motion.';
    if (!trails.value.isOn) return '';
    const kept = trailJoints.value.length > 0 ? keptTrailNames(editor) : [];
    const some = selectedJoints(session).length + kept.length > 0;
    if (!some) return 'Select joints to see their trails.';
    const names = kept.length > 0 ? ` Kept: ${kept.join(', ')}.` : '';
    return `Drag the large dots, which are keys.${names}`;
  }
}

/** A member of a signal's value, as a property that lil-gui can read and write. */
function partOf<T, Key extends keyof T>(signal: Signal<T>, key: Key): { value: T[Key] } {
  return field(
    () => signal.value[key],
    (value) => (signal.value = { ...signal.value, [key]: value }),
  );
}
