import { useState } from 'preact/hooks';
import { kernelById } from '../../../skinning/registry.ts';
import { formatDegrees } from '../../angle-text.ts';
import type { NamedSweep } from '../../deform-lab/sweep-lab.ts';

/** The numbers of a sweep, for reading and for the keyboard. */
export function SweepTable({ sweep: { angles, curves } }: { readonly sweep: NamedSweep }) {
  const [isOpen, setOpen] = useState(false);
  const columns = [
    ...curves.map(({ method, volumes }) => ({ method, name: 'volume', values: volumes })),
    ...curves.map(({ method, sections }) => ({ method, name: 'section', values: sections })),
  ];
  return (
    <details open={isOpen} onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
      <summary>As a table</summary>
      {isOpen && (
        <div class="rows" tabIndex={0} role="region" aria-label="Volume and section by angle">
          <table>
            <thead>
              <tr>
                <th scope="col">Angle</th>
                {columns.map(({ method, name }) => (
                  <th key={`${method} ${name}`} scope="col">
                    {kernelById(method).short} {name}
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {angles.map((angle, i) => (
                <tr key={angle}>
                  <th scope="row">{formatDegrees(angle)}</th>
                  {columns.map(({ method, name, values }) => (
                    <td key={`${method} ${name}`}>{percentText(values[i]!)}</td>
                  ))}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </details>
  );
}

function percentText(part: number | null): string {
  return part === null ? '–' : `${(100 * part).toFixed(1)} %`;
}
