import type { GUI } from 'lil-gui';
import type { Edit } from '../../document/edit.ts';
import { type Environment, studio } from '../../document/environment.ts';
import type { Gesture } from '../../document/store.ts';
import type { Looking } from '../editor.ts';
import { field } from './signal-field.ts';
import { addValueRow } from './value-row.ts';

/** A value of what surrounds the actors, which a row shows and changes. */
export interface EnvironmentValue<T> {
  readonly name: string;
  /** For screen readers: "Key light Strength". */
  readonly fullName: string;
  readonly read: (environment: Environment) => T;
  readonly write: (value: T, environment: Environment) => Edit;
}

export interface EnvironmentNumber extends EnvironmentValue<number> {
  readonly minimum: number;
  readonly maximum: number;
}

export interface EnvironmentRow {
  refresh(): void;
  show(visible: boolean): void;
}

/** Adds a menu. @param options the values by their labels */
export function addChoiceRow<T extends string>(
  folder: GUI,
  { store }: Looking,
  { name, fullName, read, write }: EnvironmentValue<T>,
  options: Readonly<Record<string, T>>,
): EnvironmentRow {
  const bound = field<T>(
    () => read(store.scene.value.environment),
    (value) => store.dispatch(write(value, store.scene.value.environment)),
  );
  const row = folder.add(bound, 'value', options).name(name);
  row.domElement.querySelector('select')!.setAttribute('aria-label', fullName);
  return { refresh: () => row.updateDisplay(), show: (visible) => void row.show(visible) };
}

/** A drag over the colors is one step of undo. */
export function addColorRow(
  folder: GUI,
  { store }: Looking,
  { name, fullName, read, write }: EnvironmentValue<string>,
): EnvironmentRow {
  let gesture: Gesture | null = null;
  const bound = field<string>(
    () => read(store.scene.value.environment),
    (color) => {
      const edit = write(color, store.scene.value.environment);
      if (!gesture?.isOpen) gesture = store.begin(edit.label);
      gesture.preview(edit);
    },
  );
  const row = folder.addColor(bound, 'value').name(name);
  for (const input of row.domElement.querySelectorAll('input')) {
    input.setAttribute('aria-label', fullName);
  }
  row.onFinishChange(() => {
    gesture?.commit();
    gesture = null;
  });
  return { refresh: () => row.updateDisplay(), show: (visible) => void row.show(visible) };
}

/** A double click gives the studio's number. */
export function addNumberRow(
  folder: GUI,
  { store }: Looking,
  { read, write, ...shown }: EnvironmentNumber,
): EnvironmentRow {
  const environment = (): Environment => store.scene.value.environment;
  const edit = (value: number): Edit => write(value, environment());
  return addValueRow(folder, {
    ...shown,
    legal: [shown.minimum, shown.maximum],
    isAngle: false,
    locked: false,
    read: () => read(environment()),
    begin: () => store.begin(edit(0).label),
    preview: (gesture, value) => gesture.preview(edit(value)),
    reset: () => store.dispatch(edit(read(studio))),
  });
}
