import { worldMatrices } from '../core/forward-kinematics.ts';
import type { Session } from '../document/session.ts';
import { shownSelected } from '../document/shown-pose.ts';
import type { Store } from '../document/store.ts';
import { displayTransform } from './display-transform.ts';
import { pickBox } from './pick-box.ts';
import { pickJoint, rayThrough, sizeOfPixel } from './picking.ts';
import type { Viewer } from './viewer.ts';

/** A place in the view, and how near to it is near enough. */
export interface PickPlace {
  /** From -1 (left) to 1. */
  readonly x: number;
  /** From -1 (bottom) to 1. */
  readonly y: number;
  /** CSS pixels of a view `viewHeight` tall. */
  readonly tolerance: number;
  readonly viewHeight: number;
}

/** The joint of the selected character at a place of the view, where its skeleton is shown. */
export function pickAt(
  { store, session, viewer }: { store: Store; session: Session; viewer: Viewer },
  { x, y, tolerance, viewHeight }: PickPlace,
): number | null {
  const shown = shownSelected(store, session);
  if (!shown || !session.showSkeleton.value) return null;
  const { character } = shown.state;
  const target = {
    character,
    display: displayTransform(character),
    worldFromJoint: worldMatrices(character.skeleton, shown.pose.q),
  };
  const camera = viewer.camera.value;
  const ray = rayThrough(camera, viewer.aspect, x, y);
  const style = session.skeletonStyle.value;
  const inBox = style === 'sticks' ? null : pickBox(target, ray);
  if (style === 'boxes' && character.skeleton.displayBoxes) return inBox;
  return pickJoint(target, ray, tolerance * sizeOfPixel(camera, viewHeight))?.joint ?? inBox;
}
