import type { Clip } from '../core/clip.ts';

/** The input of pose layers. */
export interface PoseContext {
  /** The clip that is bound, or null. */
  readonly clip: Clip | null;
  /** Time in the clip, in seconds. */
  readonly time: number;
}

/**
 * A source of values that are applied over the edited pose. To add one, write a file and add a line
 * to layers.ts.
 */
export interface PoseLayer {
  readonly id: string;
  isActive(context: PoseContext): boolean;
  /** @param q (qCount) read and written */
  apply(context: PoseContext, q: Float64Array): void;
}
