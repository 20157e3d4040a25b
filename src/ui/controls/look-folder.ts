import type { GUI } from 'lil-gui';
import { type ActorLook, clayCount, plainLook, type Shading } from '../../document/actor-look.ts';
import { setLook } from '../../document/look-edits.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Looking } from '../editor.ts';
import { watch } from '../watch.ts';
import { addValueRow } from './value-row.ts';

/** In the order of the studio's clays. */
const clayNames = ['Sand', 'Stone', 'Terracotta', 'Sage', 'Slate', 'Mauve', 'Umber', 'Graphite'];

/** Adds controls for how the selected character is drawn, apart from its materials. */
export function addLookFolder(gui: GUI, { store, session }: Looking): void {
  const folder = gui.addFolder('Surface');
  const look = (): ActorLook => selectedActor(store, session)?.look ?? plainLook;
  const change = (part: Partial<ActorLook>, label: string): void => {
    const actor = selectedActor(store, session);
    if (actor) store.dispatch(setLook(actor.id, part, label));
  };
  const bound = {
    get shading(): Shading {
      return look().shading;
    },
    set shading(shading: Shading) {
      change({ shading }, shading === 'smooth' ? 'Shade smoothly' : 'Shade in facets');
    },
    get clay(): number {
      return look().clay;
    },
    set clay(clay: number) {
      change({ clay }, `${clayNames[clay]!} clay`);
    },
  };
  const clays = Object.fromEntries(
    Array.from({ length: clayCount }, (_, clay) => [clayNames[clay]!, clay]),
  );
  const choices = [
    folder.add(bound, 'shading', { Smooth: 'smooth', Faceted: 'faceted' }).name('Shading'),
    folder.add(bound, 'clay', clays).name('Clay'),
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
  watch([store.scene, session.selectedActorId], () => {
    folder.show(selectedActor(store, session) !== undefined);
    for (const row of choices) row.updateDisplay();
    roughness.refresh();
  });
}
