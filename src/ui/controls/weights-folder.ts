import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import { selectedActor } from '../../document/selected-actor.ts';
import { truncationLines, truncationOf } from '../../evaluation/truncation.ts';
import { type WeightViewId, weightViews } from '../../skinning/weights/views.ts';
import { runCommand } from '../commands/command.ts';
import { commandOf } from '../commands/registry.ts';
import type { Editor } from '../editor.ts';
import { onceAFrame } from '../once-a-frame.ts';
import { influenceCounts, keepStrongest, toggleWeights } from '../weights.ts';
import { addNote } from './note.ts';
import { field, signalField } from './signal-field.ts';

/** Adds controls for weights in color, for one vertex, and for keeping few influences. */
export function addWeightsFolder(gui: GUI, editor: Editor): () => void {
  const { store, session, evaluations } = editor;
  const folder = gui.addFolder('Weights');
  const view = field<WeightViewId | 'off'>(
    () => (session.showWeights.value ? session.weightView.value : 'off'),
    (id) => {
      if ((id !== 'off') !== session.showWeights.value) toggleWeights(editor);
      if (id !== 'off') session.weightView.value = id;
    },
  );
  const kept = field<number | null>(
    () => selectedActor(store, session)?.influences ?? null,
    (count) => keepStrongest(editor, count),
  );
  const views = Object.fromEntries(weightViews.map(({ label, id }) => [label, id]));
  const rows = [
    folder.add(view, 'value', { Off: 'off', ...views }).name('Colors (v)'),
    folder.add(signalField(session.unlitWeights), 'value').name('Without light'),
    folder.add(kept, 'value', { ...influenceCounts }).name('Keep influences'),
  ];
  const endMark = addMarkField(folder, editor);
  const worst = folder
    .add({ run: () => runCommand(commandOf('worst-vertex'), editor) }, 'run')
    .name('Go to the worst vertex');
  const figures = document.createElement('div');
  folder.$children.append(figures);
  const notes = [0, 1, 2].map(() => addNote(folder, ''));
  figures.append(...notes);
  const show = onceAFrame((lines: readonly string[]) => {
    notes.forEach((note, index) => (note.textContent = lines[index] ?? ''));
  });

  const endRows = effect(() => {
    for (const row of rows) row.updateDisplay();
    const shown = evaluations.selected();
    folder.show((shown?.state.character.mesh.pointCount ?? 0) > 0);
    const found = shown && truncationOf(shown);
    worst.show(Boolean(found && found.movedCount > 0));
    show(found ? truncationLines(found) : []);
  });
  return () => {
    endMark();
    endRows();
  };
}

/** Adds a field for the number of the marked vertex. Returns what ends it. */
function addMarkField(folder: GUI, { evaluations, session }: Editor): () => void {
  const input = document.createElement('input');
  input.type = 'number';
  input.min = '0';
  input.className = 'dof-search vertex-number';
  input.placeholder = 'Vertex number, as in the file';
  input.setAttribute('aria-label', 'Vertex number');
  input.addEventListener('input', () => {
    const point = Number(input.value);
    const count = evaluations.selected()?.state.character.mesh.pointCount ?? 0;
    const isPoint = input.value !== '' && Number.isInteger(point) && point >= 0 && point < count;
    if (isPoint && !session.showWeights.value) session.showWeights.value = true;
    session.markedPoint.value = isPoint ? point : null;
  });
  folder.$children.append(input);
  return effect(() => {
    const marked = session.markedPoint.value;
    if (document.activeElement !== input) input.value = marked === null ? '' : String(marked);
  });
}
