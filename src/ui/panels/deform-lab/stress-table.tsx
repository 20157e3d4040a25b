import { useMemo } from 'preact/hooks';
import type { StressNumbers, StressRow } from '../../../evaluation/comparison/stress.ts';
import { kernelById } from '../../../skinning/registry.ts';
import { type MeasuredSuite, stressLabOf } from '../../deform-lab/stress-lab.ts';
import type { Editor } from '../../editor.ts';
import { type StressColumn, type StressQuantity, StressTableRow } from './stress-table-row.tsx';
import { useGrowing } from './use-growing.ts';

interface StressTableProperties {
  readonly editor: Editor;
  readonly suite: MeasuredSuite;
}

/** How bad a number is, or null where there is none; the worst of a column is marked. */
const badness: Readonly<Record<StressQuantity, (numbers: StressNumbers) => number | null>> = {
  largest: ({ largest }: StressNumbers) => largest,
  mean: ({ mean }: StressNumbers) => mean,
  volume: ({ volume }: StressNumbers) => volume && Math.abs(volume - 1),
};

/** What is no worse than this is not marked: the page shows no difference. */
const unnoticed = { largest: 0, mean: 0, volume: 0.0005 };

/** All poses of a suite: pictures of the worst beside the numbers. A row puts its pose on the character. */
export function StressTable({ editor, suite }: StressTableProperties) {
  const lab = stressLabOf(editor);
  const { methods, base } = suite;
  const kernels = methods.map(kernelById);
  const columns = kernels.map((kernel, index) => ({ kernel, index }));
  const others = columns.filter(({ index }) => index !== base);
  const heads: readonly (readonly [StressQuantity, string, typeof columns])[] = [
    ['largest', 'Largest difference', others],
    ['mean', 'Mean difference', others],
    ['volume', 'Volume', columns],
  ];
  const cells = useMemo(
    () =>
      heads.flatMap(([quantity, , ofQuantity]) =>
        ofQuantity.map(({ index }): StressColumn => {
          return { quantity, index, worst: worstOf(suite, quantity, index) };
        }),
      ),
    [suite],
  );
  const rows = lab.rows.value;
  const shown = useGrowing(rows.length, suite);
  return (
    <table>
      <thead>
        <tr>
          <th scope="col" rowSpan={2} class="pose">
            Pose
          </th>
          <th scope="colgroup" colSpan={columns.length}>
            Pictures
          </th>
          {heads.map(([quantity, title, { length }]) => (
            <th key={quantity} scope="colgroup" colSpan={length}>
              {title}
            </th>
          ))}
        </tr>
        <tr>
          {columns.map(({ kernel }) => (
            <th key={kernel.id} scope="col" class="of-picture" title={kernel.label}>
              {kernel.short}
            </th>
          ))}
          {cells.map(({ quantity, index }) => (
            <th key={`${quantity} ${index}`} scope="col" title={kernels[index]!.label}>
              {kernels[index]!.short}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.slice(0, shown).map((row) => (
          <StressTableRow
            key={`${row.pose.joint} ${row.pose.motion} ${row.pose.angle}`}
            {...{ editor, suite, row, columns: cells }}
          />
        ))}
      </tbody>
    </table>
  );
}

function worstOf(
  { rows }: MeasuredSuite,
  quantity: StressQuantity,
  index: number,
): StressRow | undefined {
  const valueOf = (row: StressRow): number => badness[quantity](row.numbers[index]!) ?? 0;
  const most = rows.reduce((value, row) => Math.max(value, valueOf(row)), 0);
  return most > unnoticed[quantity] ? rows.find((row) => valueOf(row) === most) : undefined;
}
