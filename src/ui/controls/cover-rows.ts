import type { GUI } from 'lil-gui';
import {
  type ActorLook,
  plainLook,
  type Projection,
  repeatsRange,
} from '../../document/actor-look.ts';
import { setLook } from '../../document/look-edits.ts';
import type { Actor } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { checkSize, projectionOf } from '../../view/dress/mapping.ts';
import type { Looking } from '../editor.ts';
import { watch } from '../watch.ts';
import { addNote } from './note.ts';
import { field } from './signal-field.ts';
import { addValueRow } from './value-row.ts';

const projections: Readonly<Record<string, Projection>> = {
  'By texture coordinates': 'uv',
  'Onto a box': 'box',
  'Around a cylinder': 'cylinder',
};

/** Adds rows for how an image or a checker lies on the surface, shown while one of them does. */
export function addCoverRows(folder: GUI, { store, session }: Looking): void {
  const selected = (): Actor | undefined => selectedActor(store, session);
  const look = (): ActorLook => selected()?.look ?? plainLook;
  const projection = field<Projection>(
    () => {
      const actor = selected();
      return actor ? projectionOf(actor.character.mesh, actor.look) : 'uv';
    },
    (projection) => {
      const actor = selected();
      if (actor) store.dispatch(setLook(actor.id, { projection }, 'Change the projection'));
      row.updateDisplay();
    },
  );
  const row = folder.add(projection, 'value', { ...projections }).name('Laid on');
  const label = 'Repeats';
  const write = (repeats: number) => setLook(selected()!.id, { repeats }, label);
  const repeats = addValueRow(folder, {
    name: label,
    fullName: `Image ${label}`,
    minimum: 0.1,
    maximum: 10,
    legal: repeatsRange,
    isAngle: false,
    locked: false,
    read: () => look().repeats,
    begin: () => store.begin(label),
    preview: (gesture, value) => gesture.preview(write(value)),
    reset: () => store.dispatch(write(plainLook.repeats)),
  });
  const note = addNote(folder, '');
  watch([store.scene, session.selectedActorId], () => {
    const isLaid = look().surface === 'image' || look().surface === 'checker';
    row.show(isLaid);
    repeats.show(isLaid);
    row.updateDisplay();
    repeats.refresh();
    const actor = selected();
    note.textContent = actor ? noteOn(actor) : '';
    note.hidden = note.textContent === '';
  });
}

function noteOn({ look, character: { mesh } }: Actor): string {
  const { surface, projection } = look;
  if (surface === 'uv') {
    return mesh.uvs
      ? 'Red is u and green is v, from 0 to 1; what is outside is tinted pink.'
      : 'This mesh has no texture coordinates to show.';
  }
  if (surface !== 'image' && surface !== 'checker') return '';
  const lacks =
    projection === 'uv' && !mesh.uvs
      ? 'This mesh has no texture coordinates, so that a box takes their place. '
      : '';
  if (surface === 'image') return `${lacks}${look.image?.name ?? ''}`;
  const unit = projectionOf(mesh, look) === 'uv' ? 'of the texture coordinates' : 'model units';
  return `${lacks}One check is ${Number(checkSize(mesh, look).toPrecision(3))} ${unit} wide.`;
}
