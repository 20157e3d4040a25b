import type { NamedNumbers } from '../evaluation/comparison/comparison-rows.ts';
import type { CharacterSize } from '../evaluation/comparison/difference.ts';
import type { RowSums } from '../evaluation/comparison/row-sums.ts';
import { rounded } from '../evaluation/truncation.ts';
import { aligned } from './aligned.ts';

/** What is printed where there is no number. */
const none = '–';

/** Says a comparison as a table for people; lengths are in the files' units. */
export function comparisonLines(
  methods: readonly NamedNumbers[],
  base: string,
  { height }: CharacterSize,
  sums: RowSums | null,
): string[] {
  const percent = (part: number): string => `${rounded(100 * part, 3)} %`;
  const rows = methods.map(({ name, difference: { largest, worst, mean }, volume, bySums }) => [
    name === base ? `${name} (base)` : name,
    rounded(largest, 4),
    percent(largest / height),
    largest > 0 ? `#${worst}` : none,
    rounded(mean, 4),
    percent(mean / height),
    volume === null ? none : `${(100 * volume).toFixed(1)} %`,
    ...(sums ? [bySums ? percent(bySums.largest / height) : none] : []),
  ]);
  const head = ['method', 'largest', 'of height', 'vertex', 'mean', 'of height', 'volume'];
  const table = aligned([[...head, ...(sums ? ['by row sums'] : [])], ...rows]);
  if (!sums) return table;
  const { count, worst, worstSum } = sums;
  const rowsText = count === 1 ? '1 row of weights does' : `${count} rows of weights do`;
  return [
    ...table,
    `${rowsText} not sum to 1, vertex #${worst} the worst with ${rounded(worstSum, 4)};` +
      ' "by row sums" is how far normalized rows move a vertex at most',
  ];
}
