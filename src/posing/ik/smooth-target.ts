import { vec3 } from 'gl-matrix';
import type { Vector3 } from './problem.ts';

/** The time constant of the low-pass, in seconds. */
const timeConstant = 0.03;

/** Where the hand was, and when. */
interface Knot {
  readonly seconds: number;
  readonly place: Vector3;
}

/**
 * A point that follows the hand through a low-pass of first order. The hand moves straight from each
 * place that is told to the next one, and for that motion the filter is exact. So what follows
 * depends on where the hand was and when, and not on the frames at which somebody asked.
 */
export class SmoothTarget {
  private seconds: number;
  /** Where the hand was at `seconds`. */
  private hand: Vector3;
  private smooth: Vector3;
  private readonly ahead: Knot[] = [];

  constructor(place: Vector3, seconds: number) {
    this.seconds = seconds;
    this.hand = place;
    this.smooth = place;
  }

  /** The last place of the hand that was told. */
  get aim(): Vector3 {
    return this.ahead.at(-1)?.place ?? this.hand;
  }

  tell(place: Vector3, seconds: number): void {
    const last = this.ahead.at(-1)?.seconds ?? this.seconds;
    if (seconds > last) this.ahead.push({ seconds, place });
    // Two places at one moment: the later one counts.
    else if (this.ahead.length > 0) this.ahead.splice(-1, 1, { seconds: last, place });
    else this.hand = place;
  }

  /** Returns the point at a moment, which is never before the last one. */
  at(seconds: number): Vector3 {
    for (;;) {
      const next = this.ahead[0];
      if (!next || next.seconds > seconds) break;
      this.pass(next.place, next.seconds);
      this.ahead.shift();
    }
    const next = this.ahead[0];
    const span = next ? (seconds - this.seconds) / (next.seconds - this.seconds) : 0;
    this.pass(next ? mix(this.hand, next.place, span) : this.hand, seconds);
    return this.smooth;
  }

  /** Ends at the hand, as after a long rest. */
  arrive(): Vector3 {
    const { aim } = this;
    this.seconds = this.ahead.at(-1)?.seconds ?? this.seconds;
    this.ahead.length = 0;
    this.hand = aim;
    this.smooth = aim;
    return aim;
  }

  /**
   * Lets the hand go straight to a place. With velocity v the solution of τ y' = x − y is
   * y = x − v τ + (y₀ − x₀ + v τ) exp(−t / τ).
   */
  private pass(to: Vector3, seconds: number): void {
    const time = seconds - this.seconds;
    if (time > 0) {
      const left = Math.exp(-time / timeConstant);
      this.smooth = [0, 1, 2].map((i) => {
        const lag = ((to[i]! - this.hand[i]!) / time) * timeConstant;
        return to[i]! - lag + (this.smooth[i]! - this.hand[i]! + lag) * left;
      }) as unknown as Vector3;
    }
    this.hand = to;
    this.seconds = seconds;
  }
}

function mix(a: Vector3, b: Vector3, part: number): Vector3 {
  const [x, y, z] = vec3.lerp(new Float64Array(3), a, b, part);
  return [x!, y!, z!];
}
