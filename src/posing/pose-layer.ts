import type { Character } from '../core/character.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import type { Unkeyed } from './unkeyed.ts';
import type { NatureSettings } from './natural/nature-settings.ts';
import type { Pin } from './pins/pin.ts';

/** What determines whether a layer is active; an actor has it all. */
export interface LayerUse {
  readonly character: Character;
  /** The clip that is bound, or its index, or null. */
  readonly clip: ClipParts | number | null;
  readonly pins: readonly Pin[];
  readonly natures: NatureSettings;
}

/** The input of pose layers. */
export interface PoseContext extends LayerUse {
  readonly clip: ClipParts | null;
  /** Time in the clip, in seconds. */
  readonly time: number;
  /** What was edited since the clip was last shown, which replaces its values; null if nothing. */
  readonly unkeyed: Unkeyed | null;
  /** (qCount) and (morphCount) the edited pose. */
  readonly q: Float64Array;
  readonly morphWeights: Float64Array;
  /**
   * (pins × 16) for each pin that follows a joint of another character, the matrix from that joint's
   * frame to this character's space, and NaN for the other pins; null if no pin follows any.
   */
  readonly followed: Float64Array | null;
}

/** What layers change: the values of q in place, weights and pins by another array. */
export interface LayerPose {
  /** (qCount) */
  readonly q: Float64Array;
  /** (morphCount) */
  morphWeights: Float64Array;
  pins: readonly Pin[];
}

/** Changes a pose. The result is a function of the context and of the pose before. */
export type LayerFunction = (context: PoseContext, pose: LayerPose) => void;

/**
 * A source of values that are applied over the edited pose, which is loaded when it is first active.
 * To add one, write a file with its function and add a line to layers.ts.
 */
export interface PoseLayer {
  /** What it does, as a label for the user while it loads. */
  readonly label: string;
  /** Whether its values are only shown: edits start from the pose without them. */
  readonly isShownOnly?: boolean;
  isActive(use: LayerUse): boolean;
  load(): Promise<LayerFunction>;
}
