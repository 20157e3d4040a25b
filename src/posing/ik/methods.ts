import { assert } from '../../core/assert.ts';
import { loadPart } from '../../core/failure.ts';
import type { IkMethod, IkMethodId } from './problem.ts';

/** Every method of inverse kinematics. To add one, write a file and add a row. */
export const ikMethods: readonly IkMethod[] = [
  {
    id: 'dls',
    label: 'Damped least squares',
    summary:
      'Moves all degrees of freedom together by the Jacobian, and otherwise stays near the start.',
    load: async () => (await loadPart(import('./dls.ts'))).dls,
  },
];

export function ikMethod(id: IkMethodId): IkMethod {
  const method = ikMethods.find((each) => each.id === id);
  assert(method !== undefined, `a method of inverse kinematics "${id}"`);
  return method;
}
