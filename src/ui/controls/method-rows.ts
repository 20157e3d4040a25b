import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import { setMethodSetting } from '../../document/method-edits.ts';
import type { Actor } from '../../document/scene.ts';
import { type MethodParameter, settingOf } from '../../skinning/method.ts';
import { kernelById } from '../../skinning/registry.ts';
import type { Editor } from '../editor.ts';
import { addNote } from './note.ts';
import { addValueRow, type ValueRow } from './value-row.ts';

/**
 * Adds rows for the parameters of the selected actor's skinning method behind a row of the folder,
 * as soon as the method is loaded; a method without parameters has none.
 */
export function addMethodRows(folder: GUI, before: HTMLElement, editor: Editor): void {
  const { evaluations } = editor;
  let own: GUI | null = null;
  let rows: readonly ValueRow[] = [];
  let shown: readonly unknown[] = [];
  effect(() => {
    const evaluation = evaluations.selected();
    const state = evaluation?.state;
    const method = evaluation?.method;
    // Another method stands in until the actor's own is there.
    const parameters = method?.id === state?.method ? method?.parameters : undefined;
    const next = [state?.id, parameters];
    if (next.some((part, index) => part !== shown[index])) {
      shown = next;
      own?.destroy();
      own = null;
      rows = [];
      if (state && parameters) {
        const added = folder.addFolder(kernelById(state.method).label);
        before.after(added.domElement);
        own = added;
        rows = parameters.map((parameter) => addRow(added, editor, state, parameter));
      }
    }
    for (const row of rows) row.refresh();
  });
}

function addRow(
  folder: GUI,
  { store, evaluations }: Editor,
  state: Actor,
  parameter: MethodParameter,
): ValueRow {
  const { label, help, least, most, initial } = parameter;
  const current = (): Actor => evaluations.selected()?.state ?? state;
  const editOf = (value: number) => setMethodSetting(current().id, parameter, value);
  const row = addValueRow(folder, {
    name: label,
    fullName: `${kernelById(state.method).label}: ${label}`,
    minimum: least,
    maximum: most,
    isAngle: false,
    locked: false,
    legal: [least, most],
    read: () => settingOf(current().methodSettings, parameter),
    begin: () => store.begin(editOf(initial).label),
    preview: (gesture, value) => gesture.preview(editOf(value)),
    reset: () => store.dispatch(editOf(initial)),
  });
  addNote(folder, help);
  return row;
}
