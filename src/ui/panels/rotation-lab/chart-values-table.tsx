import { isSingular } from '../../../posing/charts/chart.ts';
import { formatDegrees } from '../../angle-text.ts';
import { numbersOf } from '../../rotation-lab/chart-text.ts';
import type { RotationLab } from '../../rotation-lab/rotation-lab.ts';
import type { Subject } from '../../rotation-lab/subject.ts';

interface ChartValuesTableProperties {
  readonly lab: RotationLab;
  readonly subject: Subject;
}

/** The numbers of every chart at the playhead. */
export function ChartValuesTable({ lab, subject }: ChartValuesTableProperties) {
  const values = lab.values.value;
  return (
    <table>
      <caption>At {lab.time.value.toFixed(2)} s</caption>
      <tbody>
        {subject.curves.map(({ chart }, row) => {
          const shown = values[row];
          if (!shown) return null;
          return (
            <tr key={chart.id}>
              <th scope="row">
                {chart.label}
                {isSingular(chart, shown) && <span class="fold">singular</span>}
              </th>
              {numbersOf(chart).map(({ name, index, look }) => (
                <td key={name} class={look}>
                  <span class="name">{name}</span> {formatDegrees(shown[index]!)}
                </td>
              ))}
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
