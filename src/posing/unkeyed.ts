/** What was edited while a clip is bound, and is not in its curves yet. */
export interface Unkeyed {
  /** The time of the clip at which it was edited, in seconds. */
  readonly time: number;
  /** Indices of q whose own values are shown instead of the clip's, increasing. */
  readonly values: readonly number[];
  /** Indices of morphs, increasing. */
  readonly morphs: readonly number[];
  /** Pinned joints, increasing. */
  readonly pins: readonly number[];
}
