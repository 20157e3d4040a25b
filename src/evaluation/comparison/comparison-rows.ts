import type { MethodNumbers } from './compare.ts';
import type { CharacterSize } from './difference.ts';
import { sixDigits } from './six-digits.ts';

/** Numbers of a method with the name that stands over their column. */
export interface NamedNumbers extends MethodNumbers {
  readonly name: string;
}

type Row = readonly (string | number | null)[];

/**
 * Lays a comparison out as one table with one head, which spreadsheets and scripts both read:
 * `quantity, vertex` and a column for each method. First come rows that sum the methods up, without a
 * vertex; then for each point a row of its distances, whose quantity is `distance`.
 */
export function* comparisonRows(
  size: CharacterSize,
  methods: readonly NamedNumbers[],
): Iterable<Row> {
  yield ['quantity', 'vertex', ...methods.map(({ name }) => name)];
  const row = (quantity: string, value: (numbers: MethodNumbers) => number | null): Row => {
    return [quantity, null, ...methods.map(value)];
  };
  yield row('largest', ({ difference }) => sixDigits(difference.largest));
  yield row('largest vertex', ({ difference: { largest, worst } }) => (largest > 0 ? worst : null));
  yield row('largest / height', ({ difference }) => sixDigits(difference.largest / size.height));
  yield row('largest / diagonal', ({ difference }) =>
    sixDigits(difference.largest / size.diagonal),
  );
  yield row('mean', ({ difference }) => sixDigits(difference.mean));
  yield row('mean / height', ({ difference }) => sixDigits(difference.mean / size.height));
  yield row('mean / diagonal', ({ difference }) => sixDigits(difference.mean / size.diagonal));
  yield row('volume / rest', ({ volume }) => sixDigits(volume));
  yield row('largest by row sums', ({ bySums }) => sixDigits(bySums?.largest ?? null));
  yield row('mean by row sums', ({ bySums }) => sixDigits(bySums?.mean ?? null));
  const distances = methods.map(({ difference }) => difference.distances);
  for (let point = 0; point < (distances[0]?.length ?? 0); point++) {
    yield ['distance', point, ...distances.map((each) => sixDigits(each[point]!))];
  }
}
