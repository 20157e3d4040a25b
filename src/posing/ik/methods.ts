import { assert } from '../../core/assert.ts';
import { loadPart } from '../../core/failure.ts';
import type { IkMethod, IkMethodId } from './problem.ts';

/** Every method of inverse kinematics. To add one, write a file and add a row. */
export const ikMethods: readonly IkMethod[] = [
  {
    id: 'dls',
    label: 'Damped least squares',
    summary:
      'All degrees of freedom move together by the Jacobian, within their limits and natural ranges, and as near to the start as the targets allow.',
    load: async () => (await loadPart(import('./dls.ts'))).dls,
  },
  {
    id: 'ccd',
    label: 'Cyclic coordinate descent',
    summary:
      'One degree of freedom after the other moves as far as its limits allow, from the tip to the root. It bends the tip first, and does not know orientations.',
    load: async () => (await loadPart(import('./ccd.ts'))).ccd,
  },
  {
    id: 'fabrik',
    label: 'FABRIK',
    summary:
      'The joints are moved as points, to the target and back to the root; after each sweep that is projected to the degrees of freedom and their limits. It does not know orientations and slides.',
    load: async () => (await loadPart(import('./fabrik.ts'))).fabrik,
  },
];

export function ikMethod(id: IkMethodId): IkMethod {
  const method = ikMethods.find((each) => each.id === id);
  assert(method !== undefined, `a method of inverse kinematics "${id}"`);
  return method;
}
