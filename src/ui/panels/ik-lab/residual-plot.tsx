import { useState } from 'preact/hooks';
import type { IkLab, MethodRun } from '../../ik-lab.ts';
import { plotOf, plotSize } from '../../ik-lab-plot.ts';
import { endText, partText } from '../../ik-lab-text.ts';

/** A residual of at most this part of the chain's length counts as none. */
const reached = 1e-3;

/** What is left after each step, by all methods, as a plot and as a table. */
export function ResidualPlot({ lab }: { readonly lab: IkLab }) {
  const [runs, at, shown] = [lab.runs.value, lab.at.value, lab.step.value];
  const lengths = runs.map(({ steps }) => steps.length - 1);
  const errors = runs.flatMap(({ steps }) => steps.map(({ error }) => error));
  const plot = plotOf(Math.max(...lengths), Math.max(...errors));
  const { left, right, top, bottom } = plot.area;
  const goal = plot.down(reached);
  // The method of the open tab is drawn over the others.
  const id = lab.methodId.value;
  const sorted = [...runs].sort((a, b) => Number(a.method.id === id) - Number(b.method.id === id));
  return (
    <figure>
      <figcaption>What is left after each step</figcaption>
      <svg
        viewBox={`0 0 ${plotSize.width} ${plotSize.height}`}
        role="img"
        aria-label="Residual by step of every method, on logarithmic scales"
      >
        {plot.parts.map((part) => (
          <g key={part}>
            <path class="grid" d={`M${left} ${plot.down(part)}H${right}`} />
            <text x={left - 5} y={plot.down(part) + 3.5} text-anchor="end">
              {partText(part)}
            </text>
          </g>
        ))}
        {plot.steps.map((step) => (
          <text key={step} x={plot.across(step)} y={bottom + 14} text-anchor="middle">
            {step}
          </text>
        ))}
        <text x={(left + right) / 2} y={bottom + 29} text-anchor="middle">
          step
        </text>
        <path class="goal" d={`M${left} ${goal}H${right}`} />
        <text class="goal" x={right} y={goal - 4} text-anchor="end">
          reached
        </text>
        {sorted.map(({ method, steps }) => {
          const points = steps.map(({ error }, i) => `${plot.across(i)},${plot.down(error)}`);
          const last = steps.length - 1;
          return (
            <g key={method.id} class={`method-${method.id}`}>
              <polyline points={points.join(' ')} />
              <circle cx={plot.across(last)} cy={plot.down(steps[last]!.error)} r={2.5} />
            </g>
          );
        })}
        <path class="now" d={`M${plot.across(at)} ${top}V${bottom}`} />
        {shown && <circle class="now" cx={plot.across(at)} cy={plot.down(shown.error)} r={4.5} />}
      </svg>
      <ul class="ends">
        {runs.map((run) => (
          <li key={run.method.id}>
            <strong>{run.method.id.toUpperCase()}</strong> {endText(run)}
          </li>
        ))}
      </ul>
      <ResidualTable runs={runs} />
    </figure>
  );
}

function ResidualTable({ runs }: { readonly runs: readonly MethodRun[] }) {
  const [isOpen, setOpen] = useState(false);
  const count = Math.max(...runs.map(({ steps }) => steps.length));
  return (
    <details open={isOpen} onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
      <summary>As a table</summary>
      {isOpen && (
        <div class="rows" tabIndex={0} role="region" aria-label="What is left after each step">
          <table>
            <thead>
              <tr>
                <th scope="col">Step</th>
                {runs.map(({ method }) => (
                  <th key={method.id} scope="col">
                    {method.id.toUpperCase()}
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {Array.from({ length: count }, (_, i) => (
                <tr key={i}>
                  <th scope="row">{i}</th>
                  {runs.map(({ method, steps }) => (
                    <td key={method.id}>{steps[i] ? partText(steps[i].error) : ''}</td>
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
