import type { Edit } from '../document/edit.ts';
import { setMethod } from '../document/edits.ts';
import type { Preparation } from '../evaluation/preparation.ts';
import { kernelById } from '../skinning/registry.ts';
import type { Looking } from './editor.ts';

/** What methods are preparing for skins at the moment. Reading subscribes. */
export function preparing({ evaluations }: Pick<Looking, 'evaluations'>): readonly Preparation[] {
  return evaluations.pool.kernels.preparations.value?.running.value ?? [];
}

/** The methods that are being prepared, how far they are (0 to 1), and what is shown meanwhile. */
export function preparingText(running: readonly Preparation[]): {
  readonly part: number;
  readonly text: string;
} {
  const part = running.reduce((sum, { part }) => sum + part.value, 0) / running.length;
  const names = new Set(running.map(({ method }) => kernelById(method).label));
  const percent = Math.floor(100 * part);
  const isFirst = running.every(({ standIn }) => standIn === undefined);
  const shown = isFirst ? 'Linear blend' : 'The result for the former weights';
  return {
    part,
    text: `${[...names].join(', ')}: ${percent} %. ${shown} is shown until then.`,
  };
}

/** Ends the preparations; the characters that wait for them have linear blend again. */
export function stopPreparing({ evaluations, store, session }: Looking): void {
  const running = preparing({ evaluations });
  const methods = new Set<string>(running.map(({ method }) => method));
  evaluations.pool.kernels.preparations.peek()?.cancel();
  const waiting = evaluations
    .all()
    .filter(({ state, method }) => methods.has(state.method) && method.id !== state.method);
  if (waiting.length > 0) store.dispatch(backToLinearBlend(waiting.map(({ state }) => state.id)));
  const compared = session.comparison.peek();
  if (compared?.methods.some((method) => methods.has(method))) session.comparison.value = null;
}

function backToLinearBlend(ids: readonly Parameters<typeof setMethod>[0][]): Edit {
  const edits = ids.map((id) => setMethod(id, 'linear-blend'));
  return {
    label: edits[0]!.label,
    apply: (scene) => edits.reduce((changed, edit) => edit.apply(changed), scene),
  };
}
