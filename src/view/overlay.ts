import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { HandleId } from '../document/session.ts';
import type { Pixels } from '../posing/ring-turn.ts';
import type { Camera } from '../document/camera.ts';
import { axesOf, clipFromScene, eyeOf } from './camera.ts';
import { sizeOfPixel } from './picking.ts';

/** A line of the overlay: a row of straight pieces. */
export interface OverlayLine {
  /** What picking returns. */
  readonly id: HandleId;
  /** In the scene's space. */
  readonly points: readonly ReadonlyVec3[];
  /** In linear light. */
  readonly color: readonly number[];
  readonly opacity: number;
  /** In CSS pixels. */
  readonly width: number;
}

/**
 * What lies over the scene to be read and dragged, such as rings. It is data: one pass draws it,
 * and one function picks from it.
 */
export type Overlay = readonly OverlayLine[];

/** A camera and the size of its view, in CSS pixels. */
export interface OverlayView {
  readonly camera: Camera;
  readonly width: number;
  readonly height: number;
}

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
 * Returns the id of the line that is nearest to a place, or null if none is within the tolerance.
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
  for (const { id, points } of overlay) {
    const seen = points.map(toPixels);
    for (let i = 0; i + 1 < seen.length; i++) {
      const distance = distanceToPiece(place, seen[i]!, seen[i + 1]!);
      if (distance > least) continue;
      [found, least] = [id, distance];
    }
  }
  return found;
}

function distanceToPiece(place: Pixels, from: Pixels, to: Pixels): number {
  const [ax, ay] = [to[0] - from[0], to[1] - from[1]];
  const [px, py] = [place[0] - from[0], place[1] - from[1]];
  const squared = ax * ax + ay * ay;
  const part = squared > 0 ? Math.min(1, Math.max(0, (px * ax + py * ay) / squared)) : 0;
  return Math.hypot(px - part * ax, py - part * ay);
}
