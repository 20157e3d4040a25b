import type { Extrapolation } from '../../core/motion/clip-parts.ts';
import { channelOf } from '../../core/motion/edit/channels.ts';
import { setExtrapolation } from '../../core/motion/edit/extrapolation.ts';
import type { ChannelKey } from '../../core/motion/targets.ts';
import type { Editor } from '../editor.ts';
import { curveModel } from './curve-model.ts';

/** An end of the keys, beyond which a curve goes on by a rule. */
export type CurveEnd = 'before' | 'after';

export const extrapolations: Readonly<Record<Extrapolation, string>> = {
  constant: 'constant',
  linear: 'linear',
  cycle: 'cycle',
  cycle_offset: 'cycle with offset',
  bounce: 'bounce',
};

/** The curves with selected keys; without any, the one that is chosen in the curve editor. */
export function continuedCurves(editor: Editor): readonly ChannelKey[] {
  const model = curveModel(editor);
  const clip = model.shown.value?.parts;
  if (!clip) return [];
  const locked = model.locked.value;
  const selected = [...editor.session.selectedKeys.value.keys()].filter(
    (key) => !locked.has(key) && channelOf(clip, key) !== null,
  );
  if (selected.length > 0) return selected;
  const chosen = editor.session.timelineView.value === 'curves' ? model.curve.value : null;
  return chosen && !locked.has(chosen.key) ? [chosen.key] : [];
}

/** The rule that the curves have in common at an end, or null. */
export function commonExtrapolation(editor: Editor, end: CurveEnd): Extrapolation | null {
  const clip = curveModel(editor).shown.value?.parts;
  const rules = continuedCurves(editor).map((key) => clip && channelOf(clip, key)?.[end]);
  const [first] = rules;
  return first && rules.every((rule) => rule === first) ? first : null;
}

/** Lets curves go on by a rule, as one step of undo. */
export function continueCurves(editor: Editor, end: CurveEnd, rule: Extrapolation): void {
  const curves = continuedCurves(editor);
  curveModel(editor).edit(`Continue ${end} the keys: ${extrapolations[rule]}`, (clip) =>
    curves.reduce((edited, key) => setExtrapolation(edited, key, end, rule), clip),
  );
}
