import { type ComparedMethod, withMethods } from '../../../document/comparison.ts';
import { menuName } from '../../../skinning/registry.ts';
import { changeComparison, furtherKernels } from '../../deform-lab/change-comparison.ts';
import { comparedOf } from '../../deform-lab/compared.ts';
import type { Looking } from '../../editor.ts';
import { Icon } from '../icon.tsx';

/** The methods from the left: which they are, and from which one differences are counted. */
export function MethodChoices({ editor }: { readonly editor: Looking }) {
  const comparison = editor.session.comparison.value;
  const rows = comparedOf(editor)?.rows ?? [];
  if (!comparison) return null;
  const { methods, base } = comparison;
  const replace = (index: number, method: ComparedMethod | null): void =>
    changeComparison(editor, (former) =>
      withMethods(
        former,
        former.methods.flatMap((each, i) => (i === index ? (method ?? []) : each)),
      ),
    );
  return (
    <ol class="methods" aria-label="Compared methods, from the left">
      {rows.map(({ method, kernel }, index) => (
        <li key={method}>
          <label class="base" title="Differences are counted from this method">
            <input
              type="radio"
              name="deform-lab-base"
              aria-label={`Differences from ${kernel.label}`}
              checked={index === base}
              onChange={() => changeComparison(editor, (former) => ({ ...former, base: index }))}
            />
          </label>
          <select
            aria-label={`Method ${index + 1}`}
            value={method}
            onChange={({ currentTarget }) => replace(index, currentTarget.value as ComparedMethod)}
          >
            <option value={method}>
              {menuName(kernel)}
              {method === 'own' && ' (own)'}
            </option>
            {!methods.includes('own') && <option value="own">Its own</option>}
            {furtherKernels(editor).map((each) => (
              <option key={each.id} value={each.id}>
                {menuName(each)}
              </option>
            ))}
          </select>
          {methods.length > 2 && (
            <button
              type="button"
              aria-label={`Compare without ${kernel.label}`}
              title="Compare without it"
              onClick={() => replace(index, null)}
            >
              <Icon id="close" />
            </button>
          )}
        </li>
      ))}
    </ol>
  );
}
