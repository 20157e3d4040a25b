import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { HandleId } from '../document/session.ts';
import type { Trail } from '../evaluation/trails.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import { axesOf } from './camera.ts';
import { type Overlay, type OverlayFace, type OverlayView, pixelSizeAt } from './overlay.ts';
import { linear, palette } from './theme.ts';

/** A trail of a character as it is placed. */
export interface PlacedTrail extends Trail {
  readonly sceneFromCharacter: Float64Array;
  /** Of the clip, in seconds. */
  readonly present: number;
}

/** In CSS pixels: the line, and the radii of the dots of frames, of keys and of the present. */
const [lineWidth, frameRadius, keyRadius, rim, presentRadius] = [2, 2.25, 4.5, 1.5, 3.5];
const hoverScale = 1.3;
/** What comes before the present is cool and what comes after it warm, as ghosts are. */
export const [beforeColor, afterColor] = [linear('#2f6fd0'), linear('#d9691c')];
const rimColor = linear('#1c2430');
const presentColor = linear('#ffffff');
/** What is only looked at has no handle to pick. */
const id = 'trail';

/** A key of a trail that can be dragged. */
export interface TrailHandle {
  readonly id: HandleId;
  readonly trail: PlacedTrail;
  /** In seconds of the clip. */
  readonly time: number;
  /** In the character's space. */
  readonly place: Vector3;
}

export function trailHandles(trails: readonly PlacedTrail[]): readonly TrailHandle[] {
  return trails.flatMap((trail) =>
    trail.keys.map(({ time, place }) => ({
      id: `${id} ${trail.actorId} ${trail.joint} ${time}`,
      ...{ trail, time, place },
    })),
  );
}

/**
 * Returns the shapes of trails: a line through all frames, a dot a frame, larger ones at keys, and
 * one at the present.
 */
export function trailShapes(
  trails: readonly PlacedTrail[],
  view: OverlayView,
  hovered: HandleId | null,
): Overlay {
  return [
    ...trails.flatMap((trail) => lines(trail, view)),
    ...trailHandles(trails).flatMap((handle) => keyShapes(handle, view, handle.id === hovered)),
    ...trails.flatMap((trail) => presentDot(trail, view)),
  ];
}

/** The dots of keys alone, for picking. */
export function keyShapes(
  { id: own, trail, place }: TrailHandle,
  view: OverlayView,
  isHovered: boolean,
): Overlay {
  const radius = keyRadius * (isHovered ? hoverScale : 1);
  const center = inScene(trail, place);
  return [
    disk(own, center, view, radius + rim, rimColor, 12),
    disk(own, center, view, radius, palette.selected, 12),
  ];
}

function lines(trail: PlacedTrail, view: OverlayView): Overlay {
  const places = trail.frames.map(({ place }) => inScene(trail, place));
  const colors = trail.frames.map(({ time }) => (time < trail.present ? beforeColor : afterColor));
  // Each color has one line; the piece that leads over the present belongs to what comes after.
  const turn = colors.indexOf(afterColor);
  const middle = turn < 0 ? places.length : turn;
  const line = (points: readonly ReadonlyVec3[], color: readonly number[]): Overlay =>
    points.length > 1 ? [{ id, points, color, width: lineWidth, opacity: 0.9 }] : [];
  return [
    ...line(places.slice(0, middle), beforeColor),
    ...line(places.slice(Math.max(0, middle - 1)), afterColor),
    ...places.map((place, at) => disk(id, place, view, frameRadius, colors[at]!, 6)),
  ];
}

function presentDot({ frames, present, ...trail }: PlacedTrail, view: OverlayView): Overlay {
  const nearest = frames.reduce(
    (found, each) => (distanceTo(each) < distanceTo(found) ? each : found),
    frames[0] ?? { time: Infinity, place: [0, 0, 0] },
  );
  if (!(distanceTo(nearest) < Infinity)) return [];
  const center = inScene(trail, nearest.place);
  return [
    disk(id, center, view, presentRadius + rim, rimColor, 10),
    disk(id, center, view, presentRadius, presentColor, 10),
  ];

  function distanceTo({ time }: { readonly time: number }): number {
    return Math.abs(time - present);
  }
}

function inScene(
  { sceneFromCharacter }: Pick<PlacedTrail, 'sceneFromCharacter'>,
  place: Vector3,
): vec3 {
  return vec3.transformMat4(new Float64Array(3), place, sceneFromCharacter);
}

/** A regular polygon that faces the viewer, of a constant size in the picture. */
function disk(
  own: HandleId,
  center: ReadonlyVec3,
  view: OverlayView,
  radius: number,
  color: readonly number[],
  corners: number,
): OverlayFace {
  const { right, up } = axesOf(view.camera);
  const size = Math.max(0, radius * pixelSizeAt(view, center));
  const points = Array.from({ length: corners }, (_, at) => {
    const angle = (2 * Math.PI * at) / corners;
    const point = vec3.scaleAndAdd(new Float64Array(3), center, right, size * Math.cos(angle));
    return vec3.scaleAndAdd(point, point, up, size * Math.sin(angle));
  });
  return { id: own, points, color, opacity: 1, isFilled: true };
}
