import { editClip } from '../../document/clip-edits.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { RotationForm } from '../../core/motion/convert-rotation.ts';
import { formatDegrees } from '../angle-text.ts';
import { conversionsOf, type Conversion } from './conversions.ts';
import type { LabEditor } from './rotation-lab.ts';
import { type Subject, subjectOf } from './subject.ts';

/** "Euler angles", or the name of a curve of quaternions, within a sentence. */
const curveTexts: Readonly<Record<RotationForm, string>> = {
  euler: 'Euler angles',
  slerp: 'slerp',
  squad: 'squad',
};

/** Stores the rotation of the selected joint by another kind of curve, as one step of undo. */
export function storeAs(editor: LabEditor, curve: RotationForm): void {
  const { store, session, transport, notice } = editor;
  const actor = selectedActor(store, session);
  const subject = subjectOf(actor, transport.clipIndex, session.selectedJoint.value);
  if (typeof subject === 'string') {
    notice.value = subject;
    return;
  }
  const conversion = conversionsOf(subject).find((each) => each.curve === curve)!;
  notice.value = storedText(subject, conversion);
  const { converted, isStored } = conversion;
  if (!converted || isStored) return;
  const label = `Store ${subject.name} as ${curveTexts[curve]}`;
  store.dispatch(editClip(subject.actor.id, subject.index, label, () => converted));
}

function storedText({ name }: Subject, { curve, isStored, refusal, ...done }: Conversion): string {
  if (refusal) return refusal;
  const text = curveTexts[curve];
  return isStored
    ? `${name} is stored as ${text} already`
    : `${name} stored as ${text}; it ${differenceText(done)}`;
}

/** Smaller angles are rounding, in radians. */
const nothing = 1e-6;

/** "differs by at most 3.2° at 0.84 s", or that it does not. */
export function differenceText({ largest, time }: Pick<Conversion, 'largest' | 'time'>): string {
  if (largest < nothing) return 'does not differ';
  return `differs by at most ${degreesText(largest)} at ${time.toFixed(2)} s`;
}

/** With a digit after the point, or two where that would be zero or nearly so. */
export function degreesText(radians: number): string {
  const degrees = (radians * 180) / Math.PI;
  if (degrees >= 1) return formatDegrees(radians);
  return degrees < 0.01 ? 'under 0.01°' : `${degrees.toFixed(2)}°`;
}
