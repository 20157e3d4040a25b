import '../../styles/stress.css';
import { kernelById } from '../../../skinning/registry.ts';
import { showsStressSheet } from '../../deform-lab/measures-open.ts';
import { differenceText } from '../../deform-lab/difference-text.ts';
import { type MeasuredSuite, stressLabOf } from '../../deform-lab/stress-lab.ts';
import type { Editor } from '../../editor.ts';
import { CommandButton } from '../command-button.tsx';
import { Icon } from '../icon.tsx';
import { Measuring } from './measuring.tsx';
import { StressTable } from './stress-table.tsx';

/** Below the view: the strip of pictures of the stress suite, with its table. */
export function StressSheet({ editor }: { readonly editor: Editor }) {
  const lab = stressLabOf(editor);
  const [suite, progress] = [lab.measurement.result.value, lab.progress.value];
  const isWorstFirst = lab.isWorstFirst.value;
  const order = (label: string, worstFirst: boolean) => (
    <button
      type="button"
      aria-pressed={isWorstFirst === worstFirst}
      onClick={() => (lab.isWorstFirst.value = worstFirst)}
    >
      {label}
    </button>
  );
  return (
    <section class="stress-sheet" aria-label="Stress suite">
      <header>
        <h2>Stress suite{suite && ` of ${suite.name}`}</h2>
        {suite && suite.rows.length > 0 && (
          <>
            <div class="order" role="group" aria-label="Order of the poses">
              {order('Worst first', true)}
              {order('By joint', false)}
            </div>
            <CommandButton editor={editor} command="save-stress-table" />
            <CommandButton editor={editor} command="save-stress-pictures" />
          </>
        )}
        {progress && <Measuring progress={progress} cancel={() => lab.cancel()} />}
        <button
          type="button"
          class="close"
          aria-label="Close the stress suite"
          title="Close"
          onClick={() => {
            lab.cancel();
            showsStressSheet.value = false;
          }}
        >
          <Icon id="close" />
        </button>
      </header>
      {suite ? (
        <>
          <p class="hint">{summaryOf(suite, lab.pictureCount.value)}</p>
          {suite.rows.length > 0 && (
            <div class="rows" tabIndex={0} role="region" aria-label="Poses of the stress suite">
              <StressTable editor={editor} suite={suite} />
            </div>
          )}
        </>
      ) : (
        !progress && <p class="hint">Nothing was measured.</p>
      )}
    </section>
  );
}

function summaryOf({ rows, methods, base, size }: MeasuredSuite, pictures: number): string {
  if (rows.length === 0) return 'No joint deforms the skin: nothing can be compared.';
  const joints = new Set(rows.map(({ pose }) => pose.joint)).size;
  const largest = rows.reduce((most, row) => Math.max(most, row.largest), 0);
  const count = (number: number, name: string): string =>
    number === 1 ? `1 ${name}` : `${number} ${name}s`;
  const shown = rows.length > pictures ? `; the ${pictures} worst have pictures` : '';
  return (
    `${count(rows.length, 'pose')} of ${count(joints, 'joint')}${shown}. Differences from ` +
    `${kernelById(methods[base]!).label}, in per cent of the height and in units of the file: ` +
    `at most ${differenceText(largest, size)}.`
  );
}
