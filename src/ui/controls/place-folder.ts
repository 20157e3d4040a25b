import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import { setTransform } from '../../document/edits.ts';
import { type Transform, unmoved } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Looking } from '../editor.ts';
import { addValueRow, type ValueRow } from './value-row.ts';

/** In scene units; a character is one unit tall. */
const reach = 3;
const largestScale = 4;

interface PlaceValue {
  readonly name: string;
  readonly label: string;
  readonly minimum: number;
  readonly maximum: number;
  readonly legal: readonly [number, number];
  readonly isAngle: boolean;
  read(transform: Transform): number;
  write(transform: Transform, value: number): Transform;
}

/** Adds controls for the position, rotation and size of the selected character in the scene. */
export function addPlaceFolder(gui: GUI, editor: Looking): void {
  const { store, session } = editor;
  const folder = gui.addFolder('Place').close();
  const values: readonly PlaceValue[] = [moved(0), moved(1), moved(2), turned, sized];
  const rows = values.map((value) => addRow(folder, editor, value));
  effect(() => {
    folder.show(selectedActor(store, session) !== undefined);
    for (const row of rows) row.refresh();
  });
}

function moved(axis: 0 | 1 | 2): PlaceValue {
  const letter = 'XYZ'[axis]!;
  return {
    name: `Move ${letter}`,
    label: 'Move',
    minimum: -reach,
    maximum: reach,
    legal: [-1000, 1000],
    isAngle: false,
    read: ({ position }) => position[axis],
    write: (transform, value) => {
      const position = transform.position.map((old, i) => (i === axis ? value : old));
      return { ...transform, position: position as [number, number, number] };
    },
  };
}

/** Rotation about the vertical axis, the only one that the controls offer. */
const turned: PlaceValue = {
  name: 'Turn',
  label: 'Turn',
  minimum: -Math.PI,
  maximum: Math.PI,
  legal: [-1000, 1000],
  isAngle: true,
  read: ({ rotation: [, y, , w] }) => 2 * Math.atan2(y, w),
  write: (transform, angle) => {
    return { ...transform, rotation: [0, Math.sin(angle / 2), 0, Math.cos(angle / 2)] };
  },
};

const sized: PlaceValue = {
  name: 'Size',
  label: 'Size',
  minimum: 0.05,
  maximum: largestScale,
  legal: [0.001, 1000],
  isAngle: false,
  read: ({ scale }) => scale,
  write: (transform, scale) => ({ ...transform, scale }),
};

function addRow(folder: GUI, { store, session }: Looking, value: PlaceValue): ValueRow {
  const { name, minimum, maximum, legal, isAngle } = value;
  const actor = () => selectedActor(store, session);
  const labelNow = (): string => `${value.label} ${actor()?.name ?? ''}`;
  const write = (number: number) => {
    const { id, transform } = actor()!;
    return setTransform(id, value.write(transform, number), labelNow());
  };
  return addValueRow(folder, {
    name,
    fullName: `Place ${name}`,
    minimum,
    maximum,
    legal,
    isAngle,
    locked: false,
    read: () => value.read(actor()?.transform ?? unmoved),
    begin: () => store.begin(labelNow()),
    preview: (gesture, number) => gesture.preview(write(number)),
    reset: () => store.dispatch(write(value.read(unmoved))),
  });
}
