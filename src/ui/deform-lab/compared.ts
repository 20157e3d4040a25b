import { computed, type ReadonlySignal } from '@preact/signals-core';
import type { ComparedMethod } from '../../document/comparison.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import {
  type CharacterSize,
  type Difference,
  differenceOf,
  leastPart,
  sizeOf,
} from '../../evaluation/comparison/difference.ts';
import { overridesOf } from '../../evaluation/comparison/overrides.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { type KernelRow, kernelOf } from '../../skinning/registry.ts';
import type { Looking } from '../editor.ts';

/** The selected character under one of the methods. */
export interface ComparedRow {
  readonly method: ComparedMethod;
  readonly kernel: KernelRow;
  readonly evaluation: Evaluation;
  /** From the base; null for the base itself. */
  readonly difference: Difference | null;
}

/** The selected character under all methods, as it is shown now. */
export interface Compared {
  /** In the order of the methods. */
  readonly rows: readonly ComparedRow[];
  readonly base: ComparedRow;
  /** The row with the largest difference from the base; null while there is none. */
  readonly worst: (ComparedRow & { readonly difference: Difference }) | null;
  readonly size: CharacterSize;
}

const known = new WeakMap<object, ReadonlySignal<Compared | null>>();

/** The comparison of the selected character, or null while nothing is compared. */
export function comparedOf(editor: Looking): Compared | null {
  let found = known.get(editor.session);
  if (!found) known.set(editor.session, (found = computed(() => compare(editor))));
  return found.value;
}

function compare({ store, session, evaluations }: Looking): Compared | null {
  const comparison = session.comparison.value;
  const actor = selectedActor(store, session);
  if (!comparison || !actor || actor.character.mesh.pointCount === 0) return null;
  const { mesh } = actor.character;
  const size = sizeOf(actor.character);
  const shown = comparison.methods.map((method) => {
    const overrides = overridesOf(method, comparison);
    const kernel = kernelOf({ ...actor, ...overrides.deformation });
    return { method, kernel, evaluation: evaluations.of(actor, overrides) };
  });
  const { positions } = shown[comparison.base]!.evaluation.vertices();
  const rows = shown.map((row, index): ComparedRow => {
    const difference =
      index === comparison.base
        ? null
        : differenceOf(
            row.evaluation.vertices().positions,
            positions,
            mesh.pointCount,
            leastPart * size.diagonal,
          );
    return { ...row, difference };
  });
  let worst: Compared['worst'] = null;
  for (const row of rows) {
    const { difference } = row;
    if (difference && difference.largest > (worst?.difference.largest ?? 0)) {
      worst = { ...row, difference };
    }
  }
  return { rows, base: rows[comparison.base]!, worst, size };
}
