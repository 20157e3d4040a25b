import { vec3 } from 'gl-matrix';
import type { RotationPaths } from '../document/rotation-paths.ts';
import type { DisplayTransform } from '../evaluation/display-transform.ts';
import type { RotationForm } from '../core/motion/convert-rotation.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import { circleAt } from './chain-shapes.ts';
import type { Overlay, OverlayView } from './overlay.ts';
import { linear } from './theme.ts';
import type { SessionOptions } from './view-options.ts';

/** Nothing of the paths is picked. */
const id = 'rotation path';
/**
 * In CSS pixels, the first at the bottom: where paths coincide, each is seen beside the narrower one
 * over it. The colors are those of the legend, in rotation-lab.css.
 */
const looks: Readonly<Record<RotationForm, { readonly color: number[]; readonly width: number }>> =
  {
    euler: { color: linear('#d9480f'), width: 7 },
    slerp: { color: linear('#2f7fd6'), width: 4.5 },
    squad: { color: linear('#0b8f6a'), width: 2 },
  };
const order: readonly RotationForm[] = ['euler', 'slerp', 'squad'];
/** The opacity of paths that the clip does not have. */
const otherOpacity = 0.75;
const [dotRadius, rimRadius] = [4, 5.5];
const [dotColor, rim] = [linear('#ffffff'), linear('#1d2733')];

export function showsPaths({ showOverlay, rotationPaths }: SessionOptions): boolean {
  return showOverlay && rotationPaths !== null;
}

/** Returns the shapes of paths: a line for each, and a dot at each key of the stored one. */
export function pathShapes(
  { paths }: RotationPaths,
  { sceneFromCharacter }: Pick<DisplayTransform, 'sceneFromCharacter'>,
  view: OverlayView,
): Overlay {
  const toScene = (place: Vector3): vec3 =>
    vec3.transformMat4(new Float64Array(3), place, sceneFromCharacter);
  const sorted = [...paths].sort((a, b) => order.indexOf(a.curve) - order.indexOf(b.curve));
  const lines = sorted.map(({ curve, isStored, points }) => {
    return {
      id,
      ...looks[curve],
      points: points.map(toScene),
      opacity: isStored ? 1 : otherOpacity,
    };
  });
  const keys = (paths.find(({ isStored }) => isStored) ?? paths[0])?.keys ?? [];
  const dots = keys.map(toScene).flatMap((at) =>
    [
      { radius: rimRadius, color: rim },
      { radius: dotRadius, color: dotColor },
    ].map(({ radius, color }) => {
      return { id, points: circleAt(at, view, radius), color, opacity: 1, isFilled: true } as const;
    }),
  );
  return [...lines, ...dots];
}
