import { computed } from '@preact/signals-core';
import { useMemo } from 'preact/hooks';
import type { StressNumbers, StressRow } from '../../../evaluation/comparison/stress.ts';
import { stressLabel } from '../../../evaluation/comparison/stress-rows.ts';
import { kernelById } from '../../../skinning/registry.ts';
import { attempt } from '../../attempt.ts';
import { percentText } from '../../deform-lab/difference-text.ts';
import { type MeasuredSuite, stressLabOf } from '../../deform-lab/stress-lab.ts';
import type { Editor } from '../../editor.ts';
import { formatSize } from '../../number-text.ts';
import { StressPicture } from './stress-picture.tsx';

export type StressQuantity = 'largest' | 'mean' | 'volume';

/** A column of numbers: a quantity of one of the suite's methods. */
export interface StressColumn {
  readonly quantity: StressQuantity;
  readonly index: number;
  /** The row with the worst number, if any number is bad. */
  readonly worst: StressRow | undefined;
}

interface StressTableRowProperties {
  readonly editor: Editor;
  readonly suite: MeasuredSuite;
  readonly row: StressRow;
  readonly columns: readonly StressColumn[];
}

/** A pose of a suite. It is rendered anew only when something of its own changes. */
export function StressTableRow({ editor, suite, row, columns }: StressTableRowProperties) {
  const { methods, size, actor } = suite;
  const lab = stressLabOf(editor);
  const own = useMemo(
    () => ({
      pictures: computed(() => lab.pictures.drawn.value.get(row)),
      isShown: computed(() => lab.shownRow.value === row),
    }),
    [lab, row],
  );
  const [pictures, isShown] = [own.pictures.value, own.isShown.value];
  const label = stressLabel(actor.character.skeleton, row.pose);
  const text = (quantity: StressQuantity, numbers: StressNumbers) => {
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
    <tr class={isShown ? 'shown' : ''} onClick={() => attempt(editor, lab.show(row))}>
      <th scope="row" class="pose">
        <button
          type="button"
          aria-pressed={isShown}
          title="Give the character this pose, and compare there"
        >
          {label}
        </button>
      </th>
      {pictures ? (
        pictures.map((picture, index) => (
          <td key={index} class="picture">
            <StressPicture
              picture={picture}
              label={`${label}, ${kernelById(methods[index]!).label}`}
            />
          </td>
        ))
      ) : (
        <td colSpan={methods.length} class="picture none" />
      )}
      {columns.map(({ quantity, index, worst }) => (
        <td key={`${quantity} ${index}`} class={worst === row ? 'worst' : ''}>
          {text(quantity, row.numbers[index]!)}
          {worst === row && <span class="mark">worst</span>}
        </td>
      ))}
    </tr>
  );
}
