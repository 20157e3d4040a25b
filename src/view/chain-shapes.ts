import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { ShownChain } from '../document/session.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import { placeOf } from '../posing/ik/chain-problem.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import { axesOf } from './camera.ts';
import {
  type Overlay,
  type OverlayFace,
  type OverlayLine,
  type OverlayView,
  pixelSizeAt,
} from './overlay.ts';
import { arc } from './ring-lines.ts';
import { palette } from './theme.ts';
import type { SessionOptions } from './view-options.ts';

/** In CSS pixels: the lines, and the radii of a joint's dot and of the ring at a target. */
const [chainWidth, apartWidth, dotRadius, ringRadius] = [3, 2, 4, 7];
const fullTurn = 2 * Math.PI;
/** What is only looked at has no handle to pick. */
const id = 'chain';

/** The chain that a drag moves, or would move, of the selected character. */
export function chainOf({ showOverlay, shownChain, playing }: SessionOptions): ShownChain | null {
  return showOverlay && !playing ? shownChain : null;
}

/**
 * Returns the lines of a chain, from the joint that begins it to the dragged point, with a dot at
 * each joint. While the point is apart from its target, a line leads to the target.
 */
export function chainShapes(
  { characterFromJoint, display }: Evaluation,
  view: OverlayView,
  { joints, point, target, isApart }: ShownChain,
): Overlay {
  const inScene = (place: Vector3): ReadonlyVec3 =>
    vec3.transformMat4(new Float64Array(3), [...place], display.sceneFromCharacter);
  const places = joints.map((joint) => inScene(placeOf(characterFromJoint, joint, [0, 0, 0])));
  const end = inScene(placeOf(characterFromJoint, joints.at(-1)!, point));
  const color = palette.selected;
  const chain: OverlayLine = { id, points: [...places, end], color, opacity: 1, width: chainWidth };
  const dots = places.map((place) => dotAt(place, view));
  if (!target || !isApart) return [chain, ...dots, ringAt(end, view, color)];
  const wanted = inScene(target);
  const apart = { id, color: palette.litBone, opacity: 1, width: apartWidth };
  return [
    chain,
    ...dots,
    { ...apart, points: [end, wanted] },
    ringAt(wanted, view, palette.litBone),
  ];
}

function dotAt(place: ReadonlyVec3, view: OverlayView): OverlayFace {
  const points = circleAt(place, view, dotRadius);
  return { id, points, color: palette.selected, opacity: 1, isFilled: true };
}

function ringAt(place: ReadonlyVec3, view: OverlayView, color: readonly number[]): OverlayLine {
  return { id, points: circleAt(place, view, ringRadius), color, opacity: 1, width: apartWidth };
}

/** A circle that faces the viewer, of a constant size in the picture; the radius is in CSS pixels. */
export function circleAt(center: ReadonlyVec3, view: OverlayView, radius: number): vec3[] {
  const { right, up } = axesOf(view.camera);
  const size = Math.max(0, radius * pixelSizeAt(view, center));
  const [first, second] = [right, up].map((axis) => vec3.scale(new Float64Array(3), axis, size));
  return arc({ center, first: first!, second: second! }, 0, fullTurn);
}
