import {
  type ComparedMethod,
  type Comparison,
  mostMethods,
  withMethods,
} from '../../document/comparison.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { type KernelRow, kernelOf, kernels } from '../../skinning/registry.ts';
import type { Looking, Telling } from '../editor.ts';
import { aimAgain } from './open-comparison.ts';

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

/** Shows the methods side by side instead of under a wipe, or the other way round. */
export function toggleLayout(editor: Looking): void {
  changeComparison(editor, (former) => ({
    ...former,
    layout: former.layout === 'wipe' ? 'side by side' : 'wipe',
  }));
  aimAgain(editor);
}

/** Compares one method more. */
export function addMethod(editor: Looking & Telling): void {
  const [next] = furtherKernels(editor);
  const count = editor.session.comparison.peek()?.methods.length ?? mostMethods;
  if (!next || count >= mostMethods) return;
  changeComparison(editor, (former) => withMethods(former, [...former.methods, next.id]));
  aimAgain(editor);
  editor.notice.value = `${next.label} added to the comparison`;
}
