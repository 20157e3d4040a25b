import { compareWith } from '../../../evaluation/comparison/compare.ts';
import type { Compared } from '../../deform-lab/compared.ts';
import { percentText } from '../../deform-lab/difference-text.ts';
import type { Looking, Telling } from '../../editor.ts';
import { formatSize } from '../../number-text.ts';
import { useTimes } from './use-times.ts';

interface MethodTableProperties {
  readonly editor: Looking & Telling;
  readonly compared: Compared;
}

/** What each method does to the pose, in numbers. */
export function MethodTable({ editor, compared }: MethodTableProperties) {
  const { rows, base, size } = compared;
  const numbers = compareWith(
    base.evaluation,
    rows.map(({ evaluation }) => evaluation),
  );
  const times = useTimes(editor, compared);
  return (
    <div class="rows" tabIndex={0} role="region" aria-label="The methods in numbers">
      <table>
        <caption>
          Differences from {base.kernel.label}, in units of the file and per cent of the height
        </caption>
        <thead>
          <tr>
            <th scope="col">Method</th>
            <th scope="col">Largest</th>
            <th scope="col">Mean</th>
            <th scope="col" title="Of the closed parts of the mesh, against the mesh at rest">
              Volume
            </th>
            <th scope="col" title="Milliseconds for all vertices on the CPU">
              CPU ms
            </th>
            <th scope="col" title="Milliseconds for all vertices on the GPU">
              GPU ms
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map(({ method, kernel, evaluation, difference }, index) => {
            const { volume } = numbers[index]!;
            const time = times.get(kernel.id);
            const length = (value: number) => (
              <td>
                {formatSize(value)}
                <br />
                <span class="quiet">{percentText(value, size)}</span>
              </td>
            );
            return (
              <tr key={method}>
                <th scope="row" title={kernel.label}>
                  {kernel.short}
                  {evaluation.pending.length > 0 && <span class="quiet"> (preparing)</span>}
                </th>
                {difference ? (
                  <>
                    {length(difference.largest)}
                    {length(difference.mean)}
                  </>
                ) : (
                  <td colSpan={2}>the base</td>
                )}
                <td>{volume === null ? '–' : volume.toFixed(3)}</td>
                <td>{timeText(time?.cpu)}</td>
                <td>{timeText(time?.gpu)}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}

/** @param time in milliseconds; null where the device does not compute the method */
function timeText(time: number | null | undefined): string {
  if (time === undefined) return '…';
  if (time === null) return '–';
  // Clocks of browsers have steps of a tenth of a millisecond.
  return time < 0.1 ? '< 0.1' : time.toFixed(time < 10 ? 1 : 0);
}
