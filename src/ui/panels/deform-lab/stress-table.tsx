import type { StressNumbers, StressRow } from '../../../evaluation/comparison/stress.ts';
import { stressLabel } from '../../../evaluation/comparison/stress-rows.ts';
import { kernelById } from '../../../skinning/registry.ts';
import { attempt } from '../../attempt.ts';
import { percentText } from '../../deform-lab/difference-text.ts';
import { type MeasuredSuite, stressLabOf } from '../../deform-lab/stress-lab.ts';
import type { Editor } from '../../editor.ts';
import { formatSize } from '../../number-text.ts';
import { StressPicture } from './stress-picture.tsx';

interface StressTableProperties {
  readonly editor: Editor;
  readonly suite: MeasuredSuite;
}

/** How bad a number is, or null where there is none; the worst of a column is marked. */
const badness = {
  largest: ({ largest }: StressNumbers) => largest,
  mean: ({ mean }: StressNumbers) => mean,
  volume: ({ volume }: StressNumbers) => volume && Math.abs(volume - 1),
};
type Quantity = keyof typeof badness;

/** What is no worse than this is not marked: the page shows no difference. */
const unnoticed = { largest: 0, mean: 0, volume: 0.0005 };

/** All poses of a suite: pictures of the worst beside the numbers. A row puts its pose on the character. */
export function StressTable({ editor, suite }: StressTableProperties) {
  const lab = stressLabOf(editor);
  const drawn = lab.pictures.drawn.value;
  const { methods, base, size, rows, actor } = suite;
  const kernels = methods.map(kernelById);
  const columns = kernels.map((kernel, index) => ({ kernel, index }));
  const others = columns.filter(({ index }) => index !== base);
  const worst = (quantity: Quantity, index: number): StressRow | undefined => {
    const valueOf = (row: StressRow): number => badness[quantity](row.numbers[index]!) ?? 0;
    const most = rows.reduce((value, row) => Math.max(value, valueOf(row)), 0);
    return most > unnoticed[quantity] ? rows.find((row) => valueOf(row) === most) : undefined;
  };
  const heads: readonly (readonly [Quantity, string, typeof columns])[] = [
    ['largest', 'Largest difference', others],
    ['mean', 'Mean difference', others],
    ['volume', 'Volume', columns],
  ];
  const cells = heads.flatMap(([quantity, , ofQuantity]) =>
    ofQuantity.map(({ index }) => ({ quantity, index, worst: worst(quantity, index) })),
  );
  const text = (quantity: Quantity, numbers: StressNumbers) => {
    if (quantity === 'volume') return numbers.volume === null ? '–' : numbers.volume.toFixed(3);
    const length = numbers[quantity];
    return (
      <>
        {percentText(length, size)}
        <span class="quiet">{formatSize(length)}</span>
      </>
    );
  };
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
        {lab.rows.value.map((row) => {
          const label = stressLabel(actor.character.skeleton, row.pose);
          const pictures = drawn.get(row);
          return (
            <tr
              key={label}
              class={lab.shownRow.value === row ? 'shown' : ''}
              onClick={() => attempt(editor, lab.show(row))}
            >
              <th scope="row" class="pose">
                <button
                  type="button"
                  aria-pressed={lab.shownRow.value === row}
                  title="Give the character this pose, and compare there"
                >
                  {label}
                </button>
              </th>
              {pictures ? (
                pictures.map((picture, index) => (
                  <td key={index} class="picture">
                    <StressPicture picture={picture} label={`${label}, ${kernels[index]!.label}`} />
                  </td>
                ))
              ) : (
                <td colSpan={columns.length} class="picture none" />
              )}
              {cells.map(({ quantity, index, worst }) => (
                <td key={`${quantity} ${index}`} class={worst === row ? 'worst' : ''}>
                  {text(quantity, row.numbers[index]!)}
                  {worst === row && <span class="mark">worst</span>}
                </td>
              ))}
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
