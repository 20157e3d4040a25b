import type { MethodNumbers } from './compare.ts';
import type { CharacterSize } from './difference.ts';

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
  yield row('largest', ({ difference }) => shortened(difference.largest));
  yield row('largest vertex', ({ difference: { largest, worst } }) => (largest > 0 ? worst : null));
  yield row('largest / height', ({ difference }) => shortened(difference.largest / size.height));
  yield row('largest / diagonal', ({ difference }) =>
    shortened(difference.largest / size.diagonal),
  );
  yield row('mean', ({ difference }) => shortened(difference.mean));
  yield row('mean / height', ({ difference }) => shortened(difference.mean / size.height));
  yield row('mean / diagonal', ({ difference }) => shortened(difference.mean / size.diagonal));
  yield row('volume / rest', ({ volume }) => volume && shortened(volume));
  yield row('largest by row sums', ({ bySums }) => bySums && shortened(bySums.largest));
  yield row('mean by row sums', ({ bySums }) => bySums && shortened(bySums.mean));
  const distances = methods.map(({ difference }) => difference.distances);
  for (let point = 0; point < (distances[0]?.length ?? 0); point++) {
    yield ['distance', point, ...distances.map((each) => shortened(each[point]!))];
  }
}

/** Six digits, which is what float32 positions give. */
function shortened(value: number): number {
  return Number(value.toPrecision(6));
}
