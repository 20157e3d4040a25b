import {
  type ComparedMethod,
  type Comparison,
  mostMethods,
  withMethods,
} from '../../document/comparison.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { type KernelRow, kernelOf, kernels } from '../../skinning/registry.ts';
import type { Looking, Telling } from '../editor.ts';

/** Changes the comparison that is shown, if there is one. */
export function changeComparison(
  { session: { comparison } }: Pick<Looking, 'session'>,
  change: (former: Comparison) => Comparison,
): void {
  if (comparison.value) comparison.value = change(comparison.value);
}

/** The kernels that are not compared yet, those that tell the most first. */
export function furtherKernels({ store, session }: Looking): readonly KernelRow[] {
  const actor = selectedActor(store, session);
  const compared = session.comparison.value?.methods ?? [];
  const isShown = (id: ComparedMethod): boolean =>
    compared.includes(id) ||
    (actor !== undefined && compared.includes('own') && kernelOf(actor).id === id);
  const ranks = ['centers-of-rotation', 'delta-mush', 'dual-quaternion', 'linear-blend', 'rigid'];
  const rankOf = ({ id }: KernelRow): number =>
    (ranks.indexOf(id) + ranks.length + 1) % (ranks.length + 1);
  return kernels.filter(({ id }) => !isShown(id)).sort((a, b) => rankOf(a) - rankOf(b));
}

export function canAddMethod(editor: Looking): boolean {
  const count = editor.session.comparison.value?.methods.length ?? mostMethods;
  return count < mostMethods && furtherKernels(editor).length > 0;
}

/** Compares one method more. */
export function addMethod(editor: Looking & Telling): void {
  const [next] = furtherKernels(editor);
  if (!next || !canAddMethod(editor)) return;
  changeComparison(editor, (former) => withMethods(former, [...former.methods, next.id]));
  editor.notice.value = `${next.label} added to the comparison`;
}
