/**
 * The part of a rotation about one axis that brings points nearest to their targets: the angle that
 * minimizes the weighted sum of squared distances (Wang and Chen 1991, for one point). Sums of
 * several points are added up before the angle is taken.
 */
export class AxisTurn {
  #sine = 0;
  #cosine = 0;

  clear(): void {
    this.#sine = 0;
    this.#cosine = 0;
  }

  /**
   * Adds a point and its target.
   *
   * @param axis unit vector, and @param origin a point on the axis: the three numbers from `at` on
   */
  add(
    axis: Float64Array,
    origin: Float64Array,
    at: number,
    point: ArrayLike<number>,
    from: number,
    target: ArrayLike<number>,
    weight: number,
  ): void {
    const x = axis[at]!;
    const y = axis[at + 1]!;
    const z = axis[at + 2]!;
    const px = point[from]! - origin[at]!;
    const py = point[from + 1]! - origin[at + 1]!;
    const pz = point[from + 2]! - origin[at + 2]!;
    const tx = target[0]! - origin[at]!;
    const ty = target[1]! - origin[at + 1]!;
    const tz = target[2]! - origin[at + 2]!;
    const across = x * (py * tz - pz * ty) + y * (pz * tx - px * tz) + z * (px * ty - py * tx);
    const along = (x * px + y * py + z * pz) * (x * tx + y * ty + z * tz);
    this.#sine += weight * across;
    this.#cosine += weight * (px * tx + py * ty + pz * tz - along);
  }

  /** From −π to π; 0 if no angle is better than another. */
  get angle(): number {
    if (Math.hypot(this.#sine, this.#cosine) < 1e-18) return 0;
    return Math.atan2(this.#sine, this.#cosine);
  }
}
