import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { ActorId } from '../document/scene.ts';
import type { HandleId } from '../document/session.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import { pinMiss } from '../posing/pins/pin-miss.ts';
import { pinnedPoint, pinTarget } from '../posing/pins/pin-target.ts';
import { axesOf } from './camera.ts';
import { type Overlay, type OverlayLine, type OverlayView, pixelSizeAt } from './overlay.ts';
import { linear, palette } from './theme.ts';
import type { ViewOptions } from './view-options.ts';

/** A pin as a diamond at the place that it holds. */
export interface PinHandle {
  readonly id: HandleId;
  readonly actorId: ActorId;
  readonly joint: number;
  /** Where it holds and where the joint is, in the scene's space. */
  readonly place: ReadonlyVec3;
  readonly point: ReadonlyVec3;
  /** How far it misses its place, in model units; 0 if it is there. */
  readonly miss: number;
  readonly follows: boolean;
  readonly weight: number;
}

/** In CSS pixels. */
const [radius, rimWidth, missWidth, ringRadius] = [7, 2, 1.5, 11];
const rimColor = linear('#2a1d05');
const missColor = linear('#e0218a');
const idStart = 'pin ';
/** The opacity of a pin that weighs nothing. */
const faintest = 0.35;

/** Pins are hidden while a clip plays, when they would only be in the way. */
export function showsPins({ showOverlay, hasHandles, playing }: ViewOptions): boolean {
  return showOverlay && hasHandles && !playing;
}

/** The pins of a character as it is shown. */
export function pinHandles(evaluation: Evaluation): PinHandle[] {
  const { state, pins, display, characterFromJoint, followed } = evaluation;
  const toScene = (place: Vector3): vec3 =>
    vec3.transformMat4(new Float64Array(3), place, display.sceneFromCharacter);
  return pins.map((pin, at) => ({
    id: `${idStart}${state.id} ${pin.joint}`,
    actorId: state.id,
    joint: pin.joint,
    place: toScene(pinTarget(pin, followed, at).place),
    point: toScene(pinnedPoint(pin, characterFromJoint)),
    miss: pinMiss(evaluation, pin.joint),
    follows: pin.follows !== null,
    weight: pin.weight,
  }));
}

/**
 * Returns the shapes of pins: a diamond each, with a second outline if it follows somebody, and a
 * line from the joint to a place that it can't reach.
 */
export function pinShapes(
  handles: readonly PinHandle[],
  view: OverlayView,
  hovered: HandleId | null,
): Overlay {
  return handles.flatMap(({ id, place, point, miss, follows, weight }) => {
    const opacity = faintest + (1 - faintest) * weight;
    const size = pixelSizeAt(view, place) * (id === hovered ? 1.25 : 1);
    const corners = diamond(place, view, radius * size);
    const outline = (points: readonly ReadonlyVec3[]): OverlayLine => {
      const closed = [...points, points[0]!];
      return { id, points: closed, color: rimColor, width: rimWidth, opacity };
    };
    const line = { id, points: [point, place], color: missColor, width: missWidth, opacity: 1 };
    return [
      ...(miss > 0 ? [line] : []),
      {
        id,
        points: corners,
        color: miss > 0 ? missColor : palette.selected,
        opacity,
        isFilled: true,
      },
      outline(corners),
      ...(follows ? [outline(diamond(place, view, ringRadius * size))] : []),
    ];
  });
}

/** The corners of a square on its tip that faces the camera. */
function diamond(center: ReadonlyVec3, { camera }: OverlayView, reach: number): vec3[] {
  const { right, up } = axesOf(camera);
  const corner = (axis: ReadonlyVec3, by: number): vec3 =>
    vec3.scaleAndAdd(new Float64Array(3), center, axis, by);
  return [corner(right, reach), corner(up, reach), corner(right, -reach), corner(up, -reach)];
}
