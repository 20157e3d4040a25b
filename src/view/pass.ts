import type { Gpu } from '../gl/gpu.ts';
import type { Frame } from './frame.ts';
import type { Programs } from './programs.ts';

export type PassId =
  'backdrop' | 'floor' | 'skeleton' | 'mesh' | 'hidden-skeleton' | 'bone-lines' | 'axes';

/** A seam: something that is drawn. A new pass is one file and one line in the registry. */
export interface Pass {
  readonly id: PassId;
  create(gpu: Gpu, programs: Programs): PassInstance;
}

export interface PassInstance {
  draw(frame: Frame): void;
  dispose(): void;
}
