import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { HandleId } from '../document/session.ts';
import type { Pixels } from '../posing/ring-turn.ts';
import type { Camera } from '../document/camera.ts';
import { axesOf, clipFromScene, eyeOf } from './camera.ts';
import { sizeOfPixel } from './picking.ts';

/** What the lines and faces of the overlay have in common. */
interface OverlayShape {
  /** What picking returns. */
  readonly id: HandleId;
  /** In the scene's space. */
  readonly points: readonly ReadonlyVec3[];
  /** In linear light. */
  readonly color: readonly number[];
  readonly opacity: number;
}

/** A row of straight pieces. */
export interface OverlayLine extends OverlayShape {
  /** In CSS pixels. */
  readonly width: number;
  /** The width at the end of each piece, if it differs: 0 makes the head of an arrow. */
  readonly endWidth?: number;
}

/** A convex polygon that is filled. */
export interface OverlayFace extends OverlayShape {
  readonly isFilled: true;
}

/**
 * What lies over the scene to be read and dragged, such as rings. It is data: one pass draws it,
 * and one function picks from it.
 */
export type Overlay = readonly (OverlayLine | OverlayFace)[];

export function isFace(shape: OverlayLine | OverlayFace): shape is OverlayFace {
  return 'isFilled' in shape;
}

/** A camera and the size of its view, in CSS pixels. */
export interface OverlayView {
  readonly camera: Camera;
  readonly width: number;
  readonly height: number;
}

/** Half the width up to which a line counts as thin, in CSS pixels. */
const thinnest = 2;

/** Returns a function from points of the scene to pixels from the view's middle, y up. */
export function pixelsIn({ camera, width, height }: OverlayView): (point: ReadonlyVec3) => Pixels {
  const matrix = clipFromScene(camera, width / height);
  return (point) => {
    const [x, y] = vec3.transformMat4(new Float64Array(3), point, matrix);
    return [(x! * width) / 2, (y! * height) / 2];
  };
}

/** The size of a CSS pixel at a point of the scene; not positive for a point behind the viewer. */
export function pixelSizeAt({ camera, height }: OverlayView, point: ReadonlyVec3): number {
  const fromEye = vec3.subtract(new Float64Array(3), point, eyeOf(camera));
  return vec3.dot(fromEye, axesOf(camera).look) * sizeOfPixel(camera, height);
}

/**
 * Returns the id of the shape that is nearest to a place, or null if none is within the tolerance.
 * The inside of a face and of a thick line is at distance 0.
 *
 * @param place pixels from the view's middle, y up
 * @param tolerance pixels
 */
export function pickOverlay(
  overlay: Overlay,
  view: OverlayView,
  place: Pixels,
  tolerance: number,
): HandleId | null {
  const toPixels = pixelsIn(view);
  let found: HandleId | null = null;
  let least = tolerance;
  for (const shape of overlay) {
    const seen = shape.points.map(toPixels);
    const distance = isFace(shape)
      ? distanceToFace(place, seen)
      : distanceToLine(place, seen, shape);
    if (distance > least) continue;
    [found, least] = [shape.id, distance];
  }
  return found;
}

function distanceToLine(
  place: Pixels,
  seen: readonly Pixels[],
  { width, endWidth = width }: OverlayLine,
): number {
  let least = Infinity;
  for (let i = 0; i + 1 < seen.length; i++) {
    const [distance, part] = distanceToPiece(place, seen[i]!, seen[i + 1]!);
    // Thin lines are picked by their middle, so that crossing ones compete equally.
    const reach = Math.max(0, (width + (endWidth - width) * part) / 2 - thinnest);
    least = Math.min(least, Math.max(0, distance - reach));
  }
  return least;
}

function distanceToFace(place: Pixels, seen: readonly Pixels[]): number {
  let least = Infinity;
  let [lefts, rights] = [0, 0];
  seen.forEach((from, i) => {
    const to = seen[(i + 1) % seen.length]!;
    least = Math.min(least, distanceToPiece(place, from, to)[0]);
    const side =
      (to[0] - from[0]) * (place[1] - from[1]) - (to[1] - from[1]) * (place[0] - from[0]);
    if (side > 0) lefts++;
    if (side < 0) rights++;
  });
  return lefts === 0 || rights === 0 ? 0 : least;
}

/** The distance to a piece, and which part of it is nearest, from 0 to 1. */
function distanceToPiece(place: Pixels, from: Pixels, to: Pixels): [number, number] {
  const [ax, ay] = [to[0] - from[0], to[1] - from[1]];
  const [px, py] = [place[0] - from[0], place[1] - from[1]];
  const squared = ax * ax + ay * ay;
  const part = squared > 0 ? Math.min(1, Math.max(0, (px * ax + py * ay) / squared)) : 0;
  return [Math.hypot(px - part * ax, py - part * ay), part];
}
