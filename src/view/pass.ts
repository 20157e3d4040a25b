import type { Gpu } from '../gl/gpu.ts';
import type { Frame } from './frame.ts';
import type { Programs } from './programs.ts';
import type { ViewOptions } from './view-options.ts';

export type PassId =
  | 'backdrop'
  | 'checkerboard'
  | 'floor'
  | 'planar-shadow'
  | 'reflection'
  | 'skeleton'
  | 'mesh'
  | 'weights'
  | 'lit-limb'
  | 'normal-lines'
  | 'hidden-skeleton'
  | 'bone-lines'
  | 'ghosts'
  | 'trails'
  | 'inspection'
  | 'overlay'
  | 'axes';

/**
 * An extension point: a pass draws something. A new pass is one file and one line in the registry.
 */
export interface Pass {
  readonly id: PassId;
  /**
   * Whether the pass draws anything. It is created, and its shaders are compiled, for the first
   * picture that it is in.
   */
  isShown(options: ViewOptions): boolean;
  /** Whether mirrors show what it draws. */
  readonly isMirrored?: boolean;
  create(gpu: Gpu, programs: Programs): PassInstance;
}

export interface PassInstance {
  /**
   * Draws what the pass needs besides the picture, before it.
   *
   * @param drawMirrored draws what mirrors show, as another frame sees it
   */
  prepare?(frame: Frame, drawMirrored: (mirrored: Frame) => void): void;
  draw(frame: Frame): void;
  dispose(): void;
}
