import type { Actor } from '../../../document/scene.ts';
import { sizeOf } from '../../../evaluation/comparison/difference.ts';
import type { ExplainedStep } from '../../../evaluation/explain/explanation.ts';
import type { InspectedMethod } from '../../vertex-inspector/inspected.ts';
import { entryName } from '../../vertex-inspector/vertex-weights.ts';
import { EntrySwatch } from './entry-swatch.tsx';

interface MethodStepsProperties {
  readonly method: InspectedMethod;
  readonly actor: Actor;
  /** How far it is from where another method puts the vertex, as a text. */
  readonly apart: string;
}

/** What a method computes for the vertex, as tables whose last one sums to its place. */
export function MethodSteps({ method, actor, apart }: MethodStepsProperties) {
  const { height } = sizeOf(actor.character);
  // A length is shown to a ten-thousandth of the height.
  const digits = Math.min(8, Math.max(2, Math.ceil(4 - Math.log10(height || 1))));
  return (
    <section aria-label={method.label}>
      <h3>{method.label}</h3>
      {apart && <p class="hint">{apart}</p>}
      {method.note && <p class="hint">{method.note}</p>}
      {method.steps.map((step) => (
        <StepTable key={step.title} step={step} actor={actor} digits={digits} />
      ))}
    </section>
  );
}

interface StepTableProperties {
  readonly step: ExplainedStep;
  readonly actor: Actor;
  readonly digits: number;
}

function StepTable({ step: { title, columns, rows, total }, actor, digits }: StepTableProperties) {
  const cells = (values: readonly number[]) =>
    columns.map((column, i) => (
      <td key={column}>{values[i] === undefined ? '' : text(values[i])}</td>
    ));
  const text = (value: number): string => value.toFixed(digits).replace(/^-(0\.?0*)$/, '$1');
  return (
    <div class="rows" role="region" aria-label={title} tabIndex={0}>
      <table>
        <caption>{title}</caption>
        <thead>
          <tr>
            <td />
            {columns.map((column) => (
              <th key={column} scope="col">
                {column}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map(({ of, values }) => {
            const name = typeof of === 'number' ? entryName(actor, of) : of;
            return (
              <tr key={of}>
                <th scope="row" title={name}>
                  {typeof of === 'number' && <EntrySwatch actor={actor} entry={of} />}
                  {name}
                </th>
                {cells(values)}
              </tr>
            );
          })}
        </tbody>
        {total && (
          <tfoot>
            <tr>
              <th scope="row">Σ</th>
              {cells(total)}
            </tr>
          </tfoot>
        )}
      </table>
    </div>
  );
}
