import { computed, type ReadonlySignal } from '@preact/signals-core';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import type { Explanation } from '../../evaluation/explain/explanation.ts';
import { explainers } from '../../evaluation/explain/registry.ts';
import { kernelById } from '../../skinning/registry.ts';
import { comparedOf } from '../deform-lab/compared.ts';
import type { Looking } from '../editor.ts';

/** How one method reaches the inspected vertex. */
export interface InspectedMethod extends Explanation {
  readonly label: string;
  readonly evaluation: Evaluation;
}

/** The inspected vertex of the selected character, under one method or more. */
export interface Inspected {
  readonly point: number;
  /** Those that are compared, from the left, or the character's own alone. */
  readonly methods: readonly [InspectedMethod, ...InspectedMethod[]];
}

const known = new WeakMap<object, ReadonlySignal<Inspected | null>>();

/** What the inspector shows, or null while it is closed. */
export function inspectedOf(editor: Looking): Inspected | null {
  let found = known.get(editor.session);
  if (!found) known.set(editor.session, (found = computed(() => inspect(editor))));
  return found.value;
}

function inspect(editor: Looking): Inspected | null {
  const point = editor.session.inspectedPoint.value;
  const shown = editor.evaluations.selected();
  if (point === null || !shown || point >= shown.state.character.mesh.pointCount) return null;
  const compared = comparedOf(editor)?.rows.map(({ evaluation }) => evaluation);
  const explained = (compared ?? [shown]).map((evaluation): InspectedMethod => {
    // A method that is still on its way is replaced by linear blend, which is then explained.
    const { id } = evaluation.method;
    return { label: kernelById(id).label, evaluation, ...explainers[id](evaluation, point) };
  });
  const [first, ...others] = explained;
  return first ? { point, methods: [first, ...others] } : null;
}
