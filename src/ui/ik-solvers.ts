import { loadPart } from '../core/failure.ts';
import { LazyPart } from '../evaluation/lazy-part.ts';
import { ikMethods } from '../posing/ik/methods.ts';
import type { IkMethodId, IkSolver } from '../posing/ik/problem.ts';

const solvers = new Map<IkMethodId, LazyPart<IkSolver>>(
  ikMethods.map(({ id, load }) => [id, new LazyPart(load)]),
);

/** The code of a method of inverse kinematics, which is loaded when it is first needed. */
export function ikSolver(id: IkMethodId): LazyPart<IkSolver> {
  return solvers.get(id)!;
}

/** Finds how joints move by nature, which a solver keeps to. */
export const natureFinder = new LazyPart(
  async () => (await loadPart(import('../posing/natural/natures-in-use.ts'))).naturesInUse,
);
