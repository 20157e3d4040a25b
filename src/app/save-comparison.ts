import { printable } from '../core/diagnostics.ts';
import { compareWith } from '../evaluation/comparison/compare.ts';
import { comparisonRows } from '../evaluation/comparison/comparison-rows.ts';
import { writeCsv } from '../formats/csv/write-csv.ts';
import { comparedOf } from '../ui/deform-lab/compared.ts';
import type { Editor } from '../ui/editor.ts';
import { download } from '../ui/download.ts';

/** Saves the numbers of the comparison that is shown, with the difference of every point. */
export function saveComparison(editor: Editor): void {
  const compared = comparedOf(editor);
  if (!compared) {
    editor.notice.value = 'Nothing is compared; "x" compares two methods';
    return;
  }
  const { rows, base, size } = compared;
  const numbers = compareWith(
    base.evaluation,
    rows.map(({ evaluation }) => evaluation),
  );
  const named = numbers.map((each, i) => ({ name: rows[i]!.kernel.short, ...each }));
  const name = base.evaluation.state.name;
  download(`${name}-comparison.csv`, writeCsv(comparisonRows(size, named)), 'text/csv');
  const shorts = rows.map(({ kernel }) => kernel.short).join(', ');
  editor.notice.value = `Differences of ${printable(name, 40)} saved as CSV: ${shorts}`;
}
