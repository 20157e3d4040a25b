import { selectActor } from '../document/reconcile.ts';
import type { Transform } from '../document/scene.ts';
import type { Opening } from '../ui/editor.ts';
import type { CatalogueEntry, CatalogueScene } from './catalogue.ts';
import type { FileOpener } from './open-files.ts';

const degrees = Math.PI / 180;

/** A scene on its way. */
export interface OpeningScene {
  /** Settles when the first character is there, or does not come. */
  readonly first: Promise<unknown>;
  readonly all: Promise<unknown>;
}

/**
 * Opens the characters of a bundled scene, one after another, without steps of undo. The camera
 * frames all of them from the start, so that it stays when the others come.
 *
 * @param shown settles when the first one was drawn, for which the others wait
 */
export function openScene(
  { label, actors, bounds, camera }: CatalogueScene,
  entries: readonly CatalogueEntry[],
  opener: FileOpener,
  opening: Opening,
  shown: Promise<void>,
): OpeningScene {
  const { viewer, session, store, notice } = opening;
  let firstCame = (): void => undefined;
  const first = new Promise<void>((resolve) => (firstCame = resolve));
  const all = opening.whileWorking(`Loading ${label}`, async (signal, onProgress) => {
    for (const [index, { character, pose, place }] of actors.entries()) {
      const entry = entries.find(({ id }) => id === character);
      if (!entry) continue;
      const selected = session.selectedActorId.value;
      const source = { kind: 'bundled', id: character } as const;
      const way = { source, add: true, place: transformOf(place), quiet: true };
      await opener.openBundled({ ...entry, pose }, signal, onProgress, way);
      if (signal.aborted) return;
      if (index === 0) {
        viewer.camera.value = {
          ...viewer.camera.value,
          azimuth: camera.azimuth * degrees,
          elevation: camera.elevation * degrees,
        };
        viewer.frame({
          min: Float64Array.from(bounds.min),
          max: Float64Array.from(bounds.max),
        });
        notice.value = label;
        firstCame();
        await shown;
      } else if (selected !== null) selectActor(session, store.scene.value, selected);
    }
  });
  return { first: Promise.race([first, all]), all };
}

/** The place of an actor, as the scene's list has it. */
export function transformOf({
  x,
  z,
  turn,
  scale,
}: CatalogueScene['actors'][number]['place']): Transform {
  return {
    position: [x, 0, z],
    rotation: [0, Math.sin(turn / 2), 0, Math.cos(turn / 2)],
    scale,
  };
}
