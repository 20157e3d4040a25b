import type { GroupId } from './goals.ts';
import { groups, usualGroups } from './groups/registry.ts';

export interface BenchWords {
  readonly long: boolean;
  readonly check: boolean;
  readonly only: readonly GroupId[];
  readonly rounds: number;
  /** The name of the row that is added to bench/results, or null. */
  readonly save: string | null;
  /** The seconds that `npm test` took, for the row. */
  readonly testSeconds: number | null;
}

const usage = `npm run bench -- [options]
  --only=GROUP,…     ${Object.keys(groups).join(', ')}
  --long             more rounds, and the costs against vertices, joints and actors
  --rounds=N         9 by themselves, 15 with --long
  --check            compare with the last row of bench/results
  --save=NAME        add a row to bench/results and write the table of docs/performance.md; a row
                     has all groups
  --test-seconds=N   what npm test took, for the row`;

/** Throws an error with a message for the user if it does not understand a word. */
export function parseWords(words: readonly string[]): BenchWords {
  const given = new Map(
    words.map((word): [string, string] => {
      const [, name = word, value = ''] = /^--([\w-]+)(?:=(.+))?$/.exec(word) ?? [];
      return [name, value];
    }),
  );
  const take = (name: string): string | undefined => {
    const value = given.get(name);
    given.delete(name);
    return value;
  };
  const long = take('long') !== undefined;
  const check = take('check') !== undefined;
  const named = take('only')?.split(',');
  const only = named ?? usualGroups(long);
  const rounds = Number(take('rounds') ?? (long ? 15 : 9));
  const save = take('save') ?? null;
  const seconds = take('test-seconds');
  const testSeconds = seconds === undefined ? null : Number(seconds);
  const unknown = [...given.keys(), ...only.filter((id) => !(id in groups))];
  const isPartial = save !== null && named !== undefined;
  const isBad = isPartial || !(rounds >= 1) || save === '' || Number.isNaN(testSeconds);
  if (unknown.length > 0 || isBad) {
    throw new Error(`not understood: ${words.join(' ')}\n${usage}`);
  }
  return { long, check, only: only as GroupId[], rounds, save, testSeconds };
}
