import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { HandleId } from '../document/session.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import { axesOf } from './camera.ts';
import { type Overlay, type OverlayView, pickOverlay, pixelSizeAt } from './overlay.ts';
import { overlayViewAt, pixelsAt } from './overlay-place.ts';
import type { Looking, PickPlace } from './pick.ts';
import { linear, palette } from './theme.ts';
import type { SessionOptions, ViewOptions } from './view-options.ts';

/** A target of the file's inverse kinematics, where the end of its chain is. */
export interface IkTarget {
  readonly id: HandleId;
  /** The joint that is to reach the target. */
  readonly joint: number;
  /** How many joints its chain has, with that joint. */
  readonly count: number;
  /** In the character's space, and in the scene's. */
  readonly origin: Vector3;
  readonly place: ReadonlyVec3;
}

/** In CSS pixels. */
const [reach, width] = [7, 2];
/** The opacity of a square's face. */
const faint = 0.35;
const rimColor = linear('#2a1d05');

/** They stand where inverse kinematics is on, for the selected character. */
function showsTargets(
  options: Pick<SessionOptions, 'showOverlay' | 'showTargets' | 'ikMode' | 'playing'>,
): boolean {
  return options.showOverlay && options.showTargets && options.ikMode && !options.playing;
}

export function hasTargets(options: ViewOptions): boolean {
  return options.hasHandles && showsTargets(options);
}

export function ikTargets({ state, characterFromJoint, display }: Evaluation): IkTarget[] {
  const { ikChains, skeleton } = state.character;
  return ikChains.flatMap(({ effector, links }, at): IkTarget[] => {
    const [outermost] = links.slice(-1);
    if (outermost === undefined) return [];
    const [x, y, z] = characterFromJoint.subarray(effector * 16 + 12, effector * 16 + 15);
    const origin: Vector3 = [x!, y!, z!];
    return [
      {
        ...{ id: `target ${at}`, joint: effector, origin },
        count: skeleton.depths[effector]! - skeleton.depths[outermost]! + 1,
        place: vec3.transformMat4(new Float64Array(3), origin, display.sceneFromCharacter),
      },
    ];
  });
}

/** Returns a square for each target. */
export function targetShapes(
  targets: readonly IkTarget[],
  view: OverlayView,
  hovered: HandleId | null,
): Overlay {
  const { right, up } = axesOf(view.camera);
  return targets.flatMap(({ id, place }) => {
    const size = reach * pixelSizeAt(view, place) * (id === hovered ? 1.25 : 1);
    const corner = (x: number, y: number): vec3 => {
      const across = vec3.scaleAndAdd(new Float64Array(3), place, right, x * size);
      return vec3.scaleAndAdd(across, across, up, y * size);
    };
    const points = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)];
    const face = points.slice(1);
    return [
      { id, points: face, color: palette.selected, opacity: faint, isFilled: true as const },
      { id, points, color: rimColor, width: 2 * width, opacity: 1 },
      { id, points, color: palette.selected, width, opacity: 1 },
    ];
  });
}

/** Returns the target whose square is at a place of the view, or null. */
export function targetAt(look: Looking, place: PickPlace): IkTarget | null {
  const { session, evaluations } = look;
  const { showTargets, ikMode, playing } = session;
  const shown = evaluations.selected();
  const options = { showOverlay: true, showTargets: showTargets.value };
  if (!shown?.state.look.visible) return null;
  if (!showsTargets({ ...options, ikMode: ikMode.value, playing: playing.value })) return null;
  const targets = ikTargets(shown);
  const view = overlayViewAt(look, place);
  const shapes = targetShapes(targets, view, null);
  const id = pickOverlay(shapes, view, pixelsAt(view, place), place.tolerance);
  return targets.find((target) => target.id === id) ?? null;
}
