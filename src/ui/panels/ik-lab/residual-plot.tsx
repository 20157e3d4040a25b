import { useState } from 'preact/hooks';
import { numberOf } from '../../../posing/ik/lab.ts';
import type { IkLab, MethodRun } from '../../ik-lab.ts';
import { plotOf, plotSize } from '../../ik-lab-plot.ts';
import { endText, partText } from '../../ik-lab-text.ts';

/** A residual of at most this part of the chain's length counts as none. */
const reached = 1e-3;

/** What is left after each step, by all methods, as a plot and as a table. */
export function ResidualPlot({ lab }: { readonly lab: IkLab }) {
  const [runs, at, shown] = [lab.runs.value, lab.at.value, lab.step.value];
  const lengths = runs.map((run) => numberOf(run, run.steps.length - 1));
  const errors = runs.flatMap(({ steps }) => steps.map(({ error }) => error));
  const plot = plotOf(Math.max(...lengths), Math.max(...errors));
  const { left, right, top, bottom } = plot.area;
  const goal = plot.down(reached);
  const open = lab.run.value;
  const now = plot.across(open ? numberOf(open, at) : 0);
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
        {sorted.map((run) => {
          const { method, steps } = run;
          const points = steps.map(
            ({ error }, i) => [plot.across(numberOf(run, i)), plot.down(error)] as const,
          );
          const [x, y] = points.at(-1)!;
          return (
            <g key={method.id} class={`method-${method.id}`}>
              <polyline points={points.join(' ')} />
              <circle cx={x} cy={y} r={2.5} />
            </g>
          );
        })}
        <path class="now" d={`M${now} ${top}V${bottom}`} />
        {shown && <circle class="now" cx={now} cy={plot.down(shown.error)} r={4.5} />}
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
              {tableSteps(runs).map((number) => (
                <tr key={number}>
                  <th scope="row">{number}</th>
                  {runs.map((run) => {
                    const step = run.steps.find((_, i) => numberOf(run, i) === number);
                    return <td key={run.method.id}>{step ? partText(step.error) : ''}</td>;
                  })}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </details>
  );
}

/** The first steps, then each tenth, and the last one of every method. */
function tableSteps(runs: readonly MethodRun[]): number[] {
  const numbers = runs.flatMap((run) =>
    run.steps
      .map((_, i) => numberOf(run, i))
      .filter((n, i) => n < 20 || n % 10 === 0 || !run.steps[i + 1]),
  );
  return [...new Set(numbers)].sort((a, b) => a - b);
}
