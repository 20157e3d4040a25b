import type { Bone } from '../core/bones.ts';
import type { ActorId } from '../document/scene.ts';
import type { Light, SkeletonStyle } from '../document/session.ts';
import type { UniformValue } from '../gl/program.ts';
import { clipFromScene, eyeOf } from './camera.ts';
import type { CharacterView } from './character-view.ts';
import type { RenderView, Viewport } from './render-view.ts';
import type { Theme } from './theme.ts';

/** What is shown of the scene, beside the document. */
export interface ViewOptions {
  readonly showSkin: boolean;
  readonly showSkeleton: boolean;
  readonly skeletonStyle: SkeletonStyle;
  readonly showTextures: boolean;
  readonly showAxes: boolean;
  readonly translucent: boolean;
  /** Floor and backdrop; without them the picture is transparent around the characters. */
  readonly showStudio: boolean;
  readonly faceted: boolean;
  readonly selectedActorId: ActorId | null;
  /** Of the selected actor, or null. */
  readonly selectedJoint: number | null;
  readonly hoveredJoint: number | null;
  /** Of the selected character, or null: one of its own bones. */
  readonly hoveredBone: Bone | null;
  /** Key, fill and rim. */
  readonly lights: readonly Light[];
}

/** All that passes read to draw one picture. */
export interface Frame {
  readonly characters: readonly CharacterView[];
  readonly options: ViewOptions;
  readonly theme: Theme;
  readonly viewport: Viewport;
  /** Uniforms that passes share: camera, backdrop and, once prepared, lights and shadows. */
  readonly uniforms: Readonly<Record<string, UniformValue>>;
}

export function createFrame(
  characters: readonly CharacterView[],
  options: ViewOptions,
  theme: Theme,
  { camera, viewport }: RenderView,
): Frame {
  const { width, height } = viewport;
  const uniforms = {
    clipFromScene: Float32Array.from(clipFromScene(camera, width / height)),
    eye: eyeOf(camera),
    viewportSize: [width, height],
    backdropTop: theme.backdropTop,
    backdropBottom: theme.backdropBottom,
  };
  return { characters, options, theme, viewport, uniforms };
}
