import type { ClipParts, Tangent, Tcb } from '../../core/motion/clip-parts.ts';
import { setTangents } from '../../core/motion/edit/tangents.ts';
import type { KeySelection } from '../../core/motion/key-selection.ts';
import type { Editor } from '../editor.ts';
import { fixSlopes, unifySlopes } from './curve-edits.ts';
import { type CurveModel, curveModel } from './curve-model.ts';
import { keyCount } from './drag-texts.ts';
import { countOf } from './key-drags.ts';

/** The tangents that commands set; "fixed" are the present slopes as numbers. */
export type TangentKind = Extract<Tangent, string> | 'fixed' | 'tcb';

/** Sets the tangents of the selected keys, on the chosen side. */
export function setTangentKind(editor: Editor, kind: TangentKind): void {
  const model = curveModel(editor);
  const side = model.side.peek();
  editSelected(editor, model, `Make tangents ${kind}`, (clip, keys) => {
    if (kind === 'fixed') return fixSlopes(clip, keys, side);
    return setTangents(clip, keys, side, kind === 'tcb' ? { tcb: [0, 0, 0] } : kind);
  });
}

/** Gives both sides of the selected keys one slope. */
export function unifyTangents(editor: Editor): void {
  editSelected(editor, curveModel(editor), 'Unify the handles', unifySlopes);
}

/** Edits the selected keys; in the curve editor those that are seen and not locked. */
function editSelected(
  { session, notice }: Editor,
  model: CurveModel,
  label: string,
  edit: (clip: ClipParts, keys: KeySelection) => ClipParts,
): void {
  const isOfCurves = session.timelineView.peek() === 'curves';
  const keys = isOfCurves ? model.selection.peek() : session.selectedKeys.peek();
  if (countOf(keys) === 0) {
    notice.value = 'Select keys first';
    return;
  }
  model.edit(label, (clip) => edit(clip, keys));
  notice.value = `${label}: ${keyCount(countOf(keys))}`;
}

/** Sets tension, continuity and bias of the selected keys, on the chosen side. */
export function setTcb(editor: Editor, tcb: Tcb): void {
  const model = curveModel(editor);
  const side = model.side.peek();
  editSelected(editor, model, 'Set tension, continuity and bias', (clip, keys) =>
    setTangents(clip, keys, side, { tcb }),
  );
}
