import type { Samples } from './measure.ts';
import { pairedRatio } from './statistics.ts';

export interface BenchOptions {
  readonly long: boolean;
  readonly rounds: number;
}

/** A number of the table, with its quartiles if it was measured in rounds. */
export interface Value {
  readonly value: number;
  readonly lower?: number;
  readonly upper?: number;
  /** The median by processor time, where that is known. */
  readonly cpu?: number;
}

/** What a group of contenders found. */
export interface GroupResult {
  /** The values of the rows of the table (bench/goals.ts), by their ids. */
  readonly values: Readonly<Record<string, Value>>;
  readonly samples: Samples;
  /** What was counted instead of timed, by its name. */
  readonly counts: Readonly<Record<string, number | string>>;
  /** The lines of the plot. */
  readonly curves?: readonly Curve[];
}

/** How a time grows. */
export interface Curve {
  /** What is counted along x: vertices, joints or actors. */
  readonly axis: string;
  readonly what: string;
  /** The counts, with the least milliseconds of all rounds. */
  readonly points: readonly (readonly [count: number, milliseconds: number])[];
}

/** How many times as long the peer takes. */
export function timesFaster(samples: Samples, contender: string, peer: string): Value {
  const [fast, slow] = [samples[contender]!, samples[peer]!];
  const { lower, median, upper } = pairedRatio(slow, fast);
  const value = { value: median, lower, upper };
  const hasCpu = [...slow, ...fast].every(({ cpu }) => cpu !== undefined && cpu > 0);
  return hasCpu ? { ...value, cpu: pairedRatio(slow, fast, 'cpu').median } : value;
}

/** How many times as long the contender takes. */
export function timesSlower(samples: Samples, contender: string, peer: string): Value {
  return timesFaster(samples, peer, contender);
}

/** Ends the run, because its numbers would mean nothing. */
export function expectRight(isRight: boolean, message: string): void {
  if (!isRight) throw new Error(`a contender gives a wrong answer: ${message}`);
}
