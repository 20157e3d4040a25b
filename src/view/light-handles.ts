import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { Environment, Light } from '../document/environment.ts';
import type { HandleId } from '../document/session.ts';
import { axesOf } from './camera.ts';
import { lightDirection } from './light-direction.ts';
import { type Overlay, type OverlayLine, type OverlayView, pixelSizeAt } from './overlay.ts';
import { linear, palette } from './theme.ts';
import type { SessionOptions } from './view-options.ts';

/** A light as a disc on a sphere around the middle of the view. */
export interface LightHandle {
  readonly id: HandleId;
  /** Of the scene's lights. */
  readonly index: number;
  /** In the scene's space. */
  readonly place: ReadonlyVec3;
}

/** The sphere's radius as a part of the view's lesser side. */
const sphereShare = 0.36;
/** In CSS pixels. */
const [discRadius, rayStart, rayEnd, lineWidth] = [8, 13, 18, 1.75];
const rayCount = 8;
const circlePieces = 24;
/** The opacity of the line from a light to what it shines on. */
const beamOpacity = 0.5;
const idStart = 'light ';
const rimColor = linear('#3a2a10');

export function showsLights({ showOverlay, dragsLights }: SessionOptions): boolean {
  return showOverlay && dragsLights;
}

/** The index of the light to which a handle belongs, or null. */
export function lightOfHandle(id: HandleId | null): number | null {
  return id?.startsWith(idStart) ? Number(id.slice(idStart.length)) : null;
}

/** The radius in scene units of the sphere around the camera's target on which lights stand. */
export function lightSphereRadius(view: OverlayView): number {
  return sphereShare * Math.min(view.width, view.height) * pixelSizeAt(view, view.camera.target);
}

export function lightHandles({ lights }: Environment, view: OverlayView): LightHandle[] {
  const radius = lightSphereRadius(view);
  return lights.map((light: Light, index) => ({
    id: `${idStart}${index}`,
    index,
    place: vec3.scaleAndAdd(new Float64Array(3), view.camera.target, lightDirection(light), radius),
  }));
}

/**
 * Returns the lines of the handles: a disc of the light's color, a beam to the middle, and rays
 * around the light that casts shadows.
 */
export function lightLines(
  environment: Environment,
  view: OverlayView,
  hovered: HandleId | null,
): Overlay {
  const { right, up } = axesOf(view.camera);
  return lightHandles(environment, view).flatMap(({ id, index, place }) => {
    const pixel = pixelSizeAt(view, place);
    const size = id === hovered ? 1.2 * pixel : pixel;
    const around = (turn: number, radius: number): vec3 => {
      const angle = 2 * Math.PI * turn;
      const point = vec3.scaleAndAdd(
        new Float64Array(3),
        place,
        right,
        Math.cos(angle) * radius * size,
      );
      return vec3.scaleAndAdd(point, point, up, Math.sin(angle) * radius * size);
    };
    const circle = (radius: number): vec3[] =>
      Array.from({ length: circlePieces + 1 }, (_, i) => around(i / circlePieces, radius));
    const line = (
      points: OverlayLine['points'],
      color: OverlayLine['color'],
      width = lineWidth,
      opacity = 1,
    ): OverlayLine => ({ id, points, color, width, opacity });
    const rays = index === 0 ? rayCount : 0;
    return [
      line([view.camera.target, place], palette.selected, lineWidth, beamOpacity),
      {
        ...{ id, points: circle(discRadius), opacity: 1, isFilled: true },
        color: linear(environment.lights[index]!.color),
      },
      line(circle(discRadius), id === hovered ? palette.selected : rimColor),
      ...Array.from({ length: rays }, (_, i) =>
        line([around(i / rays, rayStart), around(i / rays, rayEnd)], palette.selected, 2.5),
      ),
    ];
  });
}
