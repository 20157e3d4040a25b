import { rowSumDifference, rowSumsOf } from '../../../evaluation/comparison/row-sums.ts';
import type { Compared } from '../../deform-lab/compared.ts';
import { differenceText } from '../../deform-lab/difference-text.ts';
import type { Editor } from '../../editor.ts';
import { CommandButton } from '../command-button.tsx';

interface RowSumsNoteProperties {
  readonly editor: Editor;
  readonly compared: Compared;
}

/** Where rows of weights don't sum to 1: what part of a difference is theirs, and the switch. */
export function RowSumsNote({ editor, compared: { rows, base, size } }: RowSumsNoteProperties) {
  const { comparison } = editor.session;
  const sums = rowSumsOf(base.evaluation.skin);
  if (!sums && !comparison.value?.normalizeRows) return null;
  return (
    <div class="row-sums">
      {sums ? (
        <>
          <p>
            {sums.count.toLocaleString('en')} rows of weights don’t sum to 1; vertex #{sums.worst}{' '}
            has {sums.worstSum.toFixed(4)}. This alone moves vertices by at most
          </p>
          <ul>
            {rows.map(({ method, kernel, evaluation }) => {
              const by = rowSumDifference(evaluation);
              return (
                <li key={method}>
                  {kernel.short}: {by ? differenceText(by.largest, size) : '0'}
                </li>
              );
            })}
          </ul>
        </>
      ) : (
        <p>All methods blend with rows that were divided by their sums.</p>
      )}
      <CommandButton editor={editor} command="compare-normalized" />
    </div>
  );
}
