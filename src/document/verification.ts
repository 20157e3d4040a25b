/** How far two skinnings of the same vertices are apart. */
export interface Difference {
  /** Largest |difference| of a coordinate, in the file's units. */
  readonly position: number;
  /** Its vertex, one-based as OBJ files count; 0 where nothing differs. */
  readonly vertex: number;
  /** Largest |difference| of a normal's component. */
  readonly normal: number;
  /** Whether every bit is the same. */
  readonly identical: boolean;
}

/** What there is to say of a character's numbers. */
export interface Verification extends Difference {
  /** `position` over the diagonal of the character's bounds. */
  readonly relative: number;
  /**
   * 6.837's check: largest |T · B⁻¹ − I| at the file's pose. Null where the file has bindings of its own,
   * for which the pose need not be the one at which they were made.
   */
  readonly bindError: number | null;
}
