import { vec3 } from 'gl-matrix';
import { batch } from '@preact/signals-core';
import { setInfluences } from '../document/weight-edits.ts';
import { selectedActor } from '../document/selected-actor.ts';
import { truncationLines, truncationOf } from '../evaluation/truncation.ts';
import type { Looking, Telling } from './editor.ts';

/** Shows the weights of the selected character in color, as last time, or its materials. */
export function toggleWeights({ session }: Looking): void {
  batch(() => {
    const { showWeights, showSkin, markedPoint, hoveredPoint } = session;
    showWeights.value = !showWeights.value;
    if (showWeights.value) showSkin.value = true;
    else [markedPoint.value, hoveredPoint.value] = [null, null];
  });
}

/** How many influences can be kept, by the names of the choices; null keeps all. */
export const influenceCounts: Readonly<Record<string, number | null>> = {
  ...{ All: null, '8': 8, '4': 4, '2': 2, '1': 1 },
};

/** Keeps the strongest influences of each point, or all (null), and shows what that moves. */
export function keepStrongest(editor: Looking & Telling, count: number | null): void {
  const { store, session, evaluations, notice } = editor;
  const actor = selectedActor(store, session);
  if (!actor) return;
  batch(() => {
    store.dispatch(setInfluences(actor.id, count));
    const { showWeights, weightView, showSkin } = session;
    if (count !== null)
      [showWeights.value, showSkin.value, weightView.value] = [true, true, 'error'];
    else if (weightView.value === 'error') weightView.value = 'joints';
  });
  const shown = evaluations.selected();
  const found = shown && truncationOf(shown);
  notice.value = found ? truncationLines(found).join(', ') : 'All influences are kept';
}

/** Marks a point and turns the camera to it, so that it is seen from outside. */
export function goToPoint({ evaluations, session, viewer }: Looking, point: number): void {
  const shown = evaluations.selected();
  if (!shown) return;
  const { positions, normals } = shown.vertices();
  const { sceneFromCharacter } = shown.display;
  const at = (values: Float32Array): vec3 => values.slice(point * 3, point * 3 + 3);
  const target = vec3.transformMat4(new Float64Array(3), at(positions), sceneFromCharacter);
  const end = vec3.add(new Float32Array(3), at(positions), at(normals));
  const outward = vec3.transformMat4(new Float64Array(3), end, sceneFromCharacter);
  vec3.normalize(outward, vec3.subtract(outward, outward, target));
  const camera = viewer.camera.peek();
  batch(() => {
    session.showWeights.value = true;
    session.markedPoint.value = point;
    viewer.camera.value = {
      ...camera,
      target: [target[0], target[1], target[2]],
      azimuth: Math.atan2(outward[0], outward[2]),
      elevation: Math.max(-1.2, Math.min(1.2, Math.asin(outward[1]))),
      distance: Math.min(camera.distance, nearDistance),
    };
  });
}

/** From here a limb fills the picture; scene units, in which a character is one tall. */
const nearDistance = 0.8;
