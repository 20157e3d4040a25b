import { vec3 } from 'gl-matrix';
import type { CutRole, CutSketch } from '../document/cutting.ts';
import type { DisplayTransform } from '../evaluation/display-transform.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import type { Overlay, OverlayLine } from './overlay.ts';
import { linear } from './theme.ts';
import type { SessionOptions } from './view-options.ts';

/** Nothing of the figure is picked. */
const id = 'cut';
/**
 * In CSS pixels: where outlines coincide, each is seen beside the narrower one over it. The colors are
 * those of the figure, in cutting-figure.css.
 */
const looks: Readonly<Record<CutRole, { readonly color: number[]; readonly width: number }>> = {
  rigid: { color: linear('#e07a2f'), width: 5.5 },
  blend: { color: linear('#3a9bd9'), width: 3.5 },
  third: { color: linear('#12805c'), width: 1.75 },
};
const frameColor = linear('#8a93a0');
const [frameOpacity, sheetOpacity] = [0.7, 0.1];
/** The half side of the frame, in reaches of the plane. */
const frameSize = 1.25;

export function showsCut({ showOverlay, cutSketch }: SessionOptions): boolean {
  return showOverlay && cutSketch !== null;
}

/** Returns the shapes of a figure: the plane as a faint sheet with a frame, and a line an outline. */
export function cutShapes(
  { plane, lines }: CutSketch,
  { sceneFromCharacter }: Pick<DisplayTransform, 'sceneFromCharacter'>,
): Overlay {
  const toScene = (place: Vector3): vec3 =>
    vec3.transformMat4(new Float64Array(3), place, sceneFromCharacter);
  const size = frameSize * plane.reach;
  const corners = [
    [-size, -size],
    [size, -size],
    [size, size],
    [-size, size],
  ].map(([right, rise]) => {
    const corner = vec3.scaleAndAdd(new Float64Array(3), plane.origin, plane.across, right!);
    vec3.scaleAndAdd(corner, corner, plane.up, rise!);
    return vec3.transformMat4(corner, corner, sceneFromCharacter);
  });
  const sheet = {
    ...{ id, points: corners, color: frameColor, opacity: sheetOpacity },
    isFilled: true,
  } as const;
  const frame = {
    ...{ id, points: [...corners, corners[0]!], color: frameColor },
    ...{ opacity: frameOpacity, width: 1 },
  };
  const outlines = lines.map(({ role, points }): OverlayLine => {
    return { id, ...looks[role], points: points.map(toScene), opacity: 1 };
  });
  return [sheet, frame, ...outlines];
}
