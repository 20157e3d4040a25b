/** The difference between two results of skinning the same vertices. */
export interface Difference {
  /** Largest |difference| of a coordinate, in the file's units. */
  readonly position: number;
  /** The vertex with that difference, counted from 1 as in OBJ files; 0 if nothing differs. */
  readonly vertex: number;
  /** Largest |difference| of a normal's component. */
  readonly normal: number;
  /** Whether every bit is the same. */
  readonly identical: boolean;
}

/** The result of verifying a character's numbers. */
export interface Verification extends Difference {
  /** Whether the method is computed on the CPU alone; the GPU then draws what was uploaded. */
  readonly isOnCpu: boolean;
  /** `position` divided by the diagonal of the character's bounds. */
  readonly relative: number;
  /**
   * 6.837's check: the largest |T · B⁻¹ − I| in the file's pose. Null if the file has its own
   * bindings, which may have been made in another pose.
   */
  readonly bindError: number | null;
}
