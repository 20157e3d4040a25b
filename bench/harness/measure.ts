import { randomSource, shuffled } from '../../tests/support/random.ts';

/** One measurement of a contender, in milliseconds. */
export interface Sample {
  /** Elapsed time of one run. */
  readonly wall: number;
  /** Processor time of one run, where it is known. */
  readonly cpu?: number;
  /** The time of the page's script, for frames. */
  readonly script?: number;
}

/** What is measured. Its answer was checked before. */
export interface Contender {
  readonly id: string;
  readonly sample: (round: number) => Sample | Promise<Sample>;
}

/** The samples of each contender, by its id; sample i of all contenders is of the same round. */
export type Samples = Readonly<Record<string, readonly Sample[]>>;

/**
 * Samples every contender once in each round, in an order that is shuffled anew for each round and
 * the same in every run. One more round comes before, which is not counted, so that code is
 * compiled and caches are filled.
 */
export async function measure(contenders: readonly Contender[], rounds: number): Promise<Samples> {
  const random = randomSource(rounds);
  const samples: Record<string, Sample[]> = {};
  for (const { id } of contenders) samples[id] = [];
  for (let round = -1; round < rounds; round++) {
    for (const index of shuffled(random, contenders.length)) {
      const { id, sample } = contenders[index]!;
      const taken = await sample(Math.max(0, round));
      if (round >= 0) samples[id]!.push(taken);
    }
  }
  return samples;
}

/** The time of one sample at least, in milliseconds, so that the clock's steps do not matter. */
const leastMilliseconds = 12;
/** The time after which code is compiled, also where the compiler's thread has to wait. */
const warmMilliseconds = 400;

/**
 * Makes a contender of a function of this process, which is run as often as a sample needs.
 *
 * @param run gets how often it ran before, so that it can do something else each time
 */
export function contenderOf(id: string, run: (index: number) => unknown): Contender {
  let next = 0;
  let count = 0;
  return {
    id,
    async sample() {
      if (count === 0) count = await enough();
      const cpu = process.cpuUsage();
      const wall = (await timeOf(count)) / count;
      const { user, system } = process.cpuUsage(cpu);
      return { wall, cpu: (user + system) / 1000 / count };
    },
  };

  /** Runs until the engine has compiled the code, and returns how many runs make a sample. */
  async function enough(): Promise<number> {
    for (let runs = 1; ; runs *= 2) {
      const time = await timeOf(runs);
      if (time >= warmMilliseconds) return Math.ceil((runs * leastMilliseconds) / time);
    }
  }

  async function timeOf(runs: number): Promise<number> {
    const begin = performance.now();
    for (let i = 0; i < runs; i++) {
      const result = run(next++);
      // Waiting for every result would add a turn of the event loop to each run.
      if (result instanceof Promise) await result;
    }
    return performance.now() - begin;
  }
}
