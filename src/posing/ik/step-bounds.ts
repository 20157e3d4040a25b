import { DofKind } from '../../core/skeleton.ts';
import { difference, integrate, type TangentSpace } from './tangent-space.ts';

/**
 * How far a solve may move each column: to the limits of the file and, if the start is a pose that is
 * shown, no farther from it than what looks like motion. A column's coordinate is its value in q; for
 * a ball it is its part of the rotation vector from the start.
 */
export class StepBounds {
  /** (columnCount) of the coordinates. */
  readonly low: Float64Array;
  readonly high: Float64Array;
  /** (columnCount) the coordinates of a pose, after `measure`. */
  readonly coordinates: Float64Array;
  readonly #space: TangentSpace;
  readonly #from: Float64Array;
  readonly #hasBalls: boolean;

  /**
   * @param from (qCount) the start
   * @param mostTurn how far a joint's rotation may turn from the start, in radians
   * @param length by which slides are measured: they may move `mostTurn` of it
   */
  constructor(space: TangentSpace, from: Float64Array, mostTurn: number, length: number) {
    const { columnCount, kinds, values, joints, min, max } = space;
    this.#space = space;
    this.#from = from.slice();
    this.#hasBalls = kinds.includes(DofKind.ball);
    this.coordinates = new Float64Array(columnCount);
    this.low = new Float64Array(columnCount);
    this.high = new Float64Array(columnCount);
    for (let column = 0; column < columnCount; column++) {
      const isSlide = kinds[column] === DofKind.slide;
      const isBall = kinds[column] === DofKind.ball;
      const turning = (other: number): boolean =>
        kinds[other] !== DofKind.slide && joints[other] === joints[column];
      const count = Array.from(kinds.keys()).filter(turning).length;
      const most = isSlide ? mostTurn * length : mostTurn / together(count, isBall);
      const start = isBall ? 0 : from[values[column]!]!;
      this.low[column] = Math.max(min[column]!, start - most);
      this.high[column] = Math.min(max[column]!, start + most);
    }
  }

  /** Writes the coordinates of a pose. */
  measure(q: Float64Array): void {
    const { columnCount, kinds, values } = this.#space;
    if (this.#hasBalls) difference(this.#space, this.#from, q, this.coordinates);
    for (let column = 0; column < columnCount; column++)
      if (kinds[column] !== DofKind.ball) this.coordinates[column] = q[values[column]!]!;
  }

  /** Moves a pose into the bounds. */
  clamp(q: Float64Array): void {
    const { columnCount, kinds, values } = this.#space;
    const [place, low, high] = [this.coordinates, this.low, this.high];
    this.measure(q);
    let isBeyond = false;
    for (let column = 0; column < columnCount; column++) {
      const within = Math.min(Math.max(place[column]!, low[column]!), high[column]!);
      if (kinds[column] !== DofKind.ball) q[values[column]!] = within;
      else if (within !== place[column]!) isBeyond = true;
      place[column] =
        kinds[column] === DofKind.ball ? within : within - this.#from[values[column]!]!;
    }
    if (isBeyond) integrate(this.#space, this.#from, place, q);
  }
}

/**
 * How many times as far as each of its columns a joint can turn. The axes of a ball are at right
 * angles; of three hinges, the outer and the inner one can be parallel.
 */
function together(count: number, isBall: boolean): number {
  return Math.sqrt(count === 3 && !isBall ? 5 : count);
}
