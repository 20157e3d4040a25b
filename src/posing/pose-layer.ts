import type { Clip } from '../core/clip.ts';

/** What pose layers read. */
export interface PoseContext {
  /** The clip that is bound, or null. */
  readonly clip: Clip | null;
  /** Seconds of the clip. */
  readonly time: number;
}

/** A seam: a source of poses over the one that is edited. A new one is a file and a line here. */
export interface PoseLayer {
  readonly id: string;
  isActive(context: PoseContext): boolean;
  /** @param q (qCount) read and written */
  apply(context: PoseContext, q: Float64Array): void;
}
