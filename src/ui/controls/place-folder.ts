import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import { extents, isEmpty } from '../../core/bounds.ts';
import { farthestPlace, legalScales, setTransform } from '../../document/place-edits.ts';
import { type Actor, type Transform, unmoved } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { displayTransform } from '../../evaluation/display-transform.ts';
import type { Editor } from '../editor.ts';
import { axisNames } from '../joint-values.ts';
import { placeLabel } from '../place-steps.ts';
import { formatSize } from '../number-text.ts';
import type { PlaceTool } from '../../document/session.ts';
import { addCommandRow } from './command-row.ts';
import { addNote } from './note.ts';
import { addValueRow, type ValueRow } from './value-row.ts';

/** In scene units; a fitted character is one unit tall. */
const reach = 3;
const largestScale = 4;
const axes = [0, 1, 2] as const;

interface PlaceValue {
  readonly name: string;
  readonly tool: PlaceTool;
  readonly axis?: 0 | 1 | 2;
  readonly minimum: number;
  readonly maximum: number;
  readonly legal: readonly [number, number];
  read(actor: Pick<Actor, 'id' | 'transform'>): number;
  write(actor: Pick<Actor, 'id' | 'transform'>, value: number): Transform;
}

/** Adds controls for the position, rotation and size of the selected character in the scene. */
export function addPlaceFolder(gui: GUI, editor: Editor): () => void {
  const { store, session, placeAngles } = editor;
  const folder = gui.addFolder('Place').close();
  const values: readonly PlaceValue[] = [
    ...axes.map(moved),
    ...axes.map((axis) => turned(axis, placeAngles)),
    sized,
  ];
  const rows = values.map((value) => addRow(folder, editor, value));
  addCommandRow(folder, editor, 'fit');
  const note = addNote(folder, '');
  addCommandRow(folder, editor, 'set-on-floor');
  addCommandRow(folder, editor, 'reset-place');
  const ends = [
    effect(() => {
      const actor = selectedActor(store, session);
      folder.show(actor !== undefined);
      for (const row of rows) row.refresh();
      note.textContent = actor ? sizeText(actor) : '';
    }),
    // Whoever takes up a tool wants to see its numbers.
    effect(() => {
      if (session.placeTool.value !== null) folder.open();
    }),
  ];
  return () => {
    for (const end of ends) end();
  };
}

/** How tall the file's pose is, in the file's units and as it is shown. */
function sizeText(actor: Actor): string {
  const { bounds } = actor.character;
  const height = isEmpty(bounds) ? 0 : extents(bounds)[1];
  const shown = formatSize(height * displayTransform(actor.character, actor).scale);
  const file = `${formatSize(height)} units tall in its file`;
  return actor.fitted
    ? `${file}, ${shown} here`
    : `${file}, and ${shown} here, about the file's own origin`;
}

function moved(axis: 0 | 1 | 2): PlaceValue {
  return {
    name: `Move ${axisNames[axis]}`,
    tool: 'move',
    axis,
    minimum: -reach,
    maximum: reach,
    legal: [-farthestPlace, farthestPlace],
    read: ({ transform }) => transform.position[axis],
    write: ({ transform }, value) => {
      const position = transform.position.map((old, i) => (i === axis ? value : old));
      return { ...transform, position: position as [number, number, number] };
    },
  };
}

/** A rotation is made of three angles; see `PlaceAngles`. */
function turned(axis: 0 | 1 | 2, angles: Editor['placeAngles']): PlaceValue {
  return {
    name: `Turn ${axisNames[axis]}`,
    tool: 'turn',
    axis,
    minimum: -Math.PI,
    maximum: Math.PI,
    legal: [-1000, 1000],
    read: ({ id, transform }) => angles.of(id, transform.rotation)[axis],
    write: ({ id, transform }, angle) => angles.withAngle(id, transform, axis, angle),
  };
}

const sized: PlaceValue = {
  name: 'Size',
  tool: 'scale',
  minimum: 0.05,
  maximum: largestScale,
  legal: legalScales,
  read: ({ transform }) => transform.scale,
  write: ({ transform }, scale) => ({ ...transform, scale }),
};

function addRow(folder: GUI, { store, session }: Editor, value: PlaceValue): ValueRow {
  const { name, axis, tool, minimum, maximum, legal } = value;
  const nobody = { id: 0, name: '', transform: unmoved };
  const actor = () => selectedActor(store, session) ?? nobody;
  const labelNow = (): string => placeLabel(tool, actor());
  const write = (number: number) => {
    return setTransform(actor().id, value.write(actor(), number), labelNow());
  };
  return addValueRow(folder, {
    name,
    fullName: `Place ${name}`,
    minimum,
    maximum,
    legal,
    ...(axis === undefined ? {} : { axis }),
    isAngle: tool === 'turn',
    locked: false,
    read: () => value.read(actor()),
    begin: () => store.begin(labelNow()),
    preview: (gesture, number) => gesture.preview(write(number)),
    reset: () => store.dispatch(write(tool === 'scale' ? unmoved.scale : 0)),
  });
}
