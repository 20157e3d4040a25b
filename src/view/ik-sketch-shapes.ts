import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { IkSketch } from '../document/ik-sketch.ts';
import type { DisplayTransform } from '../evaluation/display-transform.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import { axesOf } from './camera.ts';
import { type Overlay, type OverlayLine, type OverlayView, pixelSizeAt } from './overlay.ts';
import { linear, palette } from './theme.ts';
import type { SessionOptions } from './view-options.ts';

/** Nothing of a sketch is picked. */
const id = 'ik sketch';
/** In CSS pixels. */
const [chainWidth, rimWidth, earlierWidth, missWidth, crossWidth] = [4, 7, 2, 1.5, 2.5];
const ellipseWidth = 1.5;
const [jointRadius, effectorRadius, crossRadius, targetRadius] = [4.5, 6, 12, 8];
const circlePieces = 24;
/** The opacity of the earliest and of the last of the steps before the shown one. */
const [faintest, faint] = [0.12, 0.5];
const rim = linear('#2a1d05');
const targetColor = linear('#e0218a');
const ellipsoidColor = linear('#2f7fd6');
const ellipsoidOpacity = 0.7;

export function showsSketch({ showOverlay, ikSketch }: SessionOptions): boolean {
  return showOverlay && ikSketch !== null;
}

/**
 * Returns the shapes of a sketch: the chain at the shown step, fainter at earlier ones, a cross and a
 * ring at the target, a thin line from the effector to it, and the ellipsoid around the effector as
 * three crossed ellipses.
 */
export function sketchShapes(
  { chain, earlier, target, halfAxes }: IkSketch,
  { sceneFromCharacter }: Pick<DisplayTransform, 'sceneFromCharacter'>,
  view: OverlayView,
): Overlay {
  const toScene = (place: Vector3): vec3 =>
    vec3.transformMat4(new Float64Array(3), place, sceneFromCharacter);
  const line = (points: vec3[], color: readonly number[], width: number, opacity = 1) => {
    return { id, points, color, width, opacity } satisfies OverlayLine;
  };
  const shown = chain.map(toScene);
  const goal = toScene(target);
  const around = circlesFacing(view);
  const before = earlier.map((places, i) => {
    const opacity = faintest + ((faint - faintest) * (i + 1)) / earlier.length;
    return line(places.map(toScene), palette.selected, earlierWidth, opacity);
  });
  const ellipsoid = ellipses(chain.at(-1)!, halfAxes).map((points) =>
    line(points.map(toScene), ellipsoidColor, ellipseWidth, ellipsoidOpacity),
  );
  const disc = (at: vec3, radius: number, color: readonly number[]) =>
    ({ id, points: around(at, radius), color, opacity: 1, isFilled: true }) as const;
  const last = shown.length - 1;
  const [right, up] = crossAt(view, goal);
  return [
    ...before,
    ...ellipsoid,
    line([shown[last]!, goal], targetColor, missWidth),
    line(shown, rim, rimWidth),
    line(shown, palette.selected, chainWidth),
    ...shown.flatMap((at, i) => {
      const radius = i === last ? effectorRadius : jointRadius;
      return [disc(at, radius + 1.5, rim), disc(at, radius, palette.selected)];
    }),
    line(right, targetColor, crossWidth),
    line(up, targetColor, crossWidth),
    line([...around(goal, targetRadius), around(goal, targetRadius)[0]!], targetColor, crossWidth),
  ];
}

/** Returns a function that gives the corners of a circle that faces the camera. */
function circlesFacing(view: OverlayView): (center: vec3, radius: number) => vec3[] {
  const { right, up } = axesOf(view.camera);
  return (center, radius) => {
    const size = radius * pixelSizeAt(view, center);
    return Array.from({ length: circlePieces }, (_, i) => {
      const angle = (2 * Math.PI * i) / circlePieces;
      const across = vec3.scaleAndAdd(new Float64Array(3), center, right, size * Math.cos(angle));
      return vec3.scaleAndAdd(across, across, up, size * Math.sin(angle));
    });
  };
}

/** The ellipses in the planes of each two of an ellipsoid's axes. */
function ellipses(center: Vector3, halfAxes: readonly Vector3[]): Vector3[][] {
  const pairs = halfAxes.flatMap((a, i) => halfAxes.slice(i + 1).map((b) => [a, b] as const));
  return pairs.map(([a, b]) =>
    Array.from({ length: circlePieces + 1 }, (_, i) => {
      const angle = (2 * Math.PI * i) / circlePieces;
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      const at = (axis: 0 | 1 | 2): number => center[axis] + a[axis] * cos + b[axis] * sin;
      return [at(0), at(1), at(2)] as const;
    }),
  );
}

/** The two strokes of a cross that faces the camera. */
function crossAt(view: OverlayView, center: vec3): [vec3[], vec3[]] {
  const { right, up } = axesOf(view.camera);
  const size = crossRadius * pixelSizeAt(view, center);
  const stroke = (axis: ReadonlyVec3): vec3[] =>
    [-size, size].map((by) => vec3.scaleAndAdd(new Float64Array(3), center, axis, by));
  return [stroke(right), stroke(up)];
}
