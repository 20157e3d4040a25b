import type { Gpu } from '../gl/gpu.ts';
import type { Frame } from './frame.ts';
import type { Programs } from './programs.ts';
import type { ViewOptions } from './view-options.ts';

export type PassId =
  'backdrop' | 'floor' | 'skeleton' | 'mesh' | 'hidden-skeleton' | 'bone-lines' | 'axes';

/** A seam: something that is drawn. A new pass is one file and one line in the registry. */
export interface Pass {
  readonly id: PassId;
  /** Whether it draws anything. It is made, and its shaders compiled, at the first picture that it is in. */
  isShown(options: ViewOptions): boolean;
  create(gpu: Gpu, programs: Programs): PassInstance;
}

export interface PassInstance {
  draw(frame: Frame): void;
  dispose(): void;
}
