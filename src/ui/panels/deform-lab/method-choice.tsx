import type { MethodId } from '../../../skinning/method.ts';
import { menuName, methods } from '../../../skinning/registry.ts';

interface MethodChoiceProperties {
  readonly chosen: readonly MethodId[];
  readonly toggle: (method: MethodId) => void;
}

/** The methods that are measured, with the color and dash of each. */
export function MethodChoice({ chosen, toggle }: MethodChoiceProperties) {
  return (
    <fieldset class="methods">
      <legend>Methods</legend>
      {methods.map((method) => (
        <label key={method.id}>
          <input
            type="checkbox"
            checked={chosen.includes(method.id)}
            onChange={() => toggle(method.id)}
          />
          <svg class={`sample method-${method.id}`} viewBox="0 0 22 8" aria-hidden="true">
            <polyline points="1,4 21,4" />
          </svg>
          {menuName(method)}
        </label>
      ))}
    </fieldset>
  );
}
