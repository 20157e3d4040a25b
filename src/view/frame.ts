import { mat4, type vec3 } from 'gl-matrix';
import type { Detail } from '../document/session.ts';
import type { UniformValue } from '../gl/program.ts';
import type { Camera } from '../document/camera.ts';
import { clipFromScene as projectionOf, eyeOf, nearOf } from './camera.ts';
import type { CharacterView } from './character-view.ts';
import type { RenderView, Viewport } from './render-view.ts';
import { type Theme, themeIn } from './theme.ts';
import type { ViewOptions } from './view-options.ts';

type Size = Pick<Viewport, 'width' | 'height'>;

/** Everything that passes read to draw one picture. */
export interface Frame {
  readonly characters: readonly CharacterView[];
  readonly options: ViewOptions;
  /** With the colors of the scene's own background, if it has one. */
  readonly theme: Theme;
  readonly camera: Camera;
  readonly viewport: Viewport;
  /** The part of the viewport that is in the picture. */
  readonly clip: Viewport;
  readonly detail: Detail;
  /** How wide lines are, as a factor of their width on the page. */
  readonly scale: number;
  /** The camera's place in the scene, and the distance before it at which things are cut off. */
  readonly eye: vec3;
  readonly near: number;
  /** In float64; the uniforms have it rounded. */
  readonly clipFromScene: mat4;
  /** The uniforms that passes share: camera, backdrop and, once prepared, lights and shadows. */
  readonly uniforms: Readonly<Record<string, UniformValue>>;
}

/** The size of a picture of a view. */
export function pictureSize({ width, height }: Size, detail: Detail): Size {
  const scale = scaleOf(detail);
  return { width: Math.ceil(width * scale), height: Math.ceil(height * scale) };
}

function scaleOf(detail: Detail): number {
  return detail === 'draft' ? 0.5 : 1;
}

export function createFrame(
  characters: readonly CharacterView[],
  options: ViewOptions,
  plainTheme: Theme,
  { camera, viewport, clip = viewport, lineScale = 1, window }: RenderView,
  detail: Detail = 'full',
): Frame {
  const { width, height } = viewport;
  const eye = eyeOf(camera);
  const theme = themeIn(options.environment, plainTheme);
  const picture = window ?? { x: 0, y: 0, width, height };
  const clipFromScene = projectionOf(camera, picture.width / picture.height);
  if (window) mat4.multiply(clipFromScene, window.tileFromPicture, clipFromScene);
  const uniforms = {
    clipFromScene: Float32Array.from(clipFromScene),
    eye,
    viewportSize: [width, height],
    pictureSize: [picture.width, picture.height],
    pictureOffset: [picture.x, picture.y],
    backdropTop: theme.backdropTop,
    backdropBottom: theme.backdropBottom,
  };
  return {
    characters,
    options,
    theme,
    camera,
    viewport,
    clip,
    detail,
    scale: scaleOf(detail) * lineScale,
    eye,
    near: nearOf(camera),
    clipFromScene,
    uniforms,
  };
}
