import type { GUI } from 'lil-gui';
import {
  type ActorLook,
  clayCount,
  plainLook,
  type Shading,
  type SurfaceKind,
} from '../../document/actor-look.ts';
import { setLook } from '../../document/look-edits.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { runCommand } from '../commands/command.ts';
import { commandOf } from '../commands/registry.ts';
import type { Editor } from '../editor.ts';
import { watch } from '../watch.ts';
import { addCommandRow } from './command-row.ts';
import { addCoverRows } from './cover-rows.ts';
import { field } from './signal-field.ts';
import { addValueRow } from './value-row.ts';

/** In the order of the studio's clays. */
const clayNames = ['Sand', 'Stone', 'Terracotta', 'Sage', 'Slate', 'Mauve', 'Umber', 'Graphite'];

const surfaces: Readonly<Record<string, SurfaceKind>> = {
  'As in the file': 'file',
  Clay: 'clay',
  Image: 'image',
  Checker: 'checker',
  'UV colors': 'uv',
};

/** Adds controls for how the selected character is drawn. */
export function addLookFolder(gui: GUI, editor: Editor): void {
  const { store, session } = editor;
  const folder = gui.addFolder('Surface');
  const look = (): ActorLook => selectedActor(store, session)?.look ?? plainLook;
  const change = (part: Partial<ActorLook>, label: string): void => {
    const actor = selectedActor(store, session);
    if (actor) store.dispatch(setLook(actor.id, part, label));
  };
  const shading = field<Shading>(
    () => look().shading,
    (shading) => change({ shading }, shading === 'smooth' ? 'Shade smoothly' : 'Shade in facets'),
  );
  const surface = field<SurfaceKind>(
    () => look().surface,
    (surface) => {
      // An image has to be chosen before it can cover anything.
      if (surface === 'image' && !look().image) runCommand(commandOf('choose-image'), editor);
      else change({ surface }, `Surface: ${nameOf(surface)}`);
      surfaceRow.updateDisplay();
    },
  );
  const clay = field<number>(
    () => look().clay,
    (clay) => change({ clay }, `${clayNames[clay]!} clay`),
  );
  const clays = Object.fromEntries(
    Array.from({ length: clayCount }, (_, clay) => [clayNames[clay]!, clay]),
  );
  const shadings = { Smooth: 'smooth', Faceted: 'faceted' };
  const surfaceRow = folder.add(surface, 'value', { ...surfaces }).name('Surface');
  const choices = [
    folder.add(shading, 'value', shadings).name('Shading'),
    surfaceRow,
    folder.add(clay, 'value', clays).name('Clay'),
  ];
  const label = 'Roughness';
  const write = (roughness: number) =>
    setLook(selectedActor(store, session)!.id, { roughness }, label);
  const roughness = addValueRow(folder, {
    name: label,
    fullName: `Clay ${label}`,
    minimum: 0,
    maximum: 1,
    legal: [0, 1],
    isAngle: false,
    locked: false,
    read: () => look().roughness,
    begin: () => store.begin(label),
    preview: (gesture, value) => gesture.preview(write(value)),
    reset: () => store.dispatch(write(plainLook.roughness)),
  });
  addCoverRows(folder, editor);
  addCommandRow(folder, editor, 'choose-image');
  watch([store.scene, session.selectedActorId], () => {
    folder.show(selectedActor(store, session) !== undefined);
    for (const row of choices) row.updateDisplay();
    roughness.refresh();
  });
}

function nameOf(surface: SurfaceKind): string {
  return Object.keys(surfaces)
    .find((name) => surfaces[name] === surface)!
    .toLowerCase();
}
