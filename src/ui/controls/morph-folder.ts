import type { Edit } from '../../document/edit.ts';
import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import type { Character } from '../../core/character.ts';
import { setMorphWeight } from '../../document/edits.ts';
import type { ActorId } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Looking } from '../editor.ts';
import { keyedState } from '../keyed-state.ts';
import { addSearch } from './search-field.ts';
import { addValueRow, type ValueRow } from './value-row.ts';

/** The largest weight that can be typed. A morph is defined from 0 to 1 and exaggerated beyond. */
const reach = 100;
/** A longer list of morphs can be searched. */
const longList = 12;

/** Adds a slider from 0 to 1 for every morph of the selected character. */
export function addMorphFolder(gui: GUI, editor: Looking): void {
  const { store, session } = editor;
  const folder = gui.addFolder('Morphs');
  let shown: Character | null = null;
  let shownId: ActorId | null = null;
  let rows: ValueRow[] = [];

  effect(() => {
    const state = selectedActor(store, session);
    const character = state?.character ?? null;
    if (character !== shown || (state?.id ?? null) !== shownId) {
      shown = character;
      shownId = state?.id ?? null;
      for (const child of [...folder.children]) child.destroy();
      folder.$children.replaceChildren();
      const morphs = character?.morphs ?? [];
      if (morphs.length > longList) {
        addSearch(folder, 'Search morphs', 'Search morphs', (wanted) => {
          rows.forEach((row, index) =>
            row.show(morphs[index]!.name.toLowerCase().includes(wanted)),
          );
        });
      }
      rows = morphs.map(({ name }, index) => addMorphRow(folder, editor, state!.id, name, index));
      folder.show(rows.length > 0);
    }
    for (const row of rows) row.refresh();
  });
}

function addMorphRow(
  folder: GUI,
  editor: Looking,
  id: number,
  name: string,
  index: number,
): ValueRow {
  const { store, evaluations } = editor;
  const label = `Shape ${name}`;
  const shown = (): Float64Array =>
    evaluations.selected()?.pose.morphWeights ?? new Float64Array(index + 1);
  const set = (weight: number, name: string): Edit =>
    setMorphWeight(id, shown(), index, weight, name);
  return addValueRow(folder, {
    name,
    fullName: name,
    minimum: 0,
    maximum: 1,
    isAngle: false,
    locked: false,
    legal: [-reach, reach],
    read: () => shown()[index] ?? 0,
    keyed: () => keyedState(editor, evaluations.selected()?.state, 'morphs', index),
    begin: () => store.begin(label),
    preview: (gesture, value) => gesture.preview(set(value, label)),
    reset: () => store.dispatch(set(0, `Reset ${name}`)),
  });
}
