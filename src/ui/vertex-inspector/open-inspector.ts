import { batch } from '@preact/signals-core';
import { comparedOf } from '../deform-lab/compared.ts';
import type { Editor } from '../editor.ts';
import { goToSection } from '../toggle-lab.ts';

/** Closes the inspector, or opens it at a vertex that tells much. */
export async function toggleInspector(editor: Editor): Promise<void> {
  const { session, tab, notice } = editor;
  if (session.inspectedPoint.value !== null && tab.value === 'deform') {
    session.inspectedPoint.value = null;
    return;
  }
  session.inspectedPoint.value ??= tellingPoint(editor);
  if (session.inspectedPoint.value === null) {
    notice.value = 'There is no character with a mesh whose vertices could be inspected';
    return;
  }
  await goToSection(editor, 'deform', 'vertex-inspector');
}

/** Inspects a vertex that is chosen in the view; on a phone the view stays. */
export function inspectPoint({ session, tab }: Editor, point: number): void {
  batch(() => {
    session.inspectedPoint.value = point;
    tab.value = 'deform';
  });
}

/** The marked vertex, or where compared methods differ most, or what joints share most equally. */
function tellingPoint(editor: Editor): number | null {
  const shown = editor.evaluations.selected();
  const worst = comparedOf(editor)?.worst?.difference.worst;
  return editor.session.markedPoint.value ?? worst ?? (shown ? mostShared(shown.skin) : null);
}

/** The point whose largest weight is the smallest. */
function mostShared({
  start,
  weights,
}: {
  readonly start: Uint32Array;
  readonly weights: Float32Array;
}): number | null {
  let found: number | null = null;
  let least = Infinity;
  for (let point = 0; point + 1 < start.length; point++) {
    let largest = 0;
    for (let i = start[point]!; i < start[point + 1]!; i++) {
      largest = Math.max(largest, Math.abs(weights[i]!));
    }
    if (largest >= least) continue;
    [found, least] = [point, largest];
  }
  return found;
}
