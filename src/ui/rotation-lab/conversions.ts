import { convertRotation } from '../../core/motion/convert-rotation.ts';
import type { ClipParts } from '../../core/motion/clip-parts.ts';
import type { RotationForm } from '../../core/motion/convert-rotation.ts';
import type { Subject } from './subject.ts';

/** The motion of a joint through the same keys, by one kind of curve. */
export interface Conversion {
  readonly curve: RotationForm;
  readonly isStored: boolean;
  /** The clip with the joint's rotation stored so; null if that can't be. */
  readonly converted: ClipParts | null;
  /** Why it can't be, for the user; empty if it can. */
  readonly refusal: string;
  /** The largest angle between the motion and the stored one, in radians, and its time. */
  readonly largest: number;
  readonly time: number;
}

/** The kinds of curves in the order in which they are shown. */
export const curveLabels: Readonly<Record<RotationForm, string>> = {
  euler: 'Euler',
  slerp: 'Slerp',
  squad: 'Squad',
};

const curves = Object.keys(curveLabels) as RotationForm[];

/** Returns the motion by every kind of curve. */
export function conversionsOf(subject: Subject): readonly Conversion[] {
  const { actor, clip, joint, motion } = subject;
  const { character } = actor;
  return curves.map((curve) => {
    const isStored = curve === motion.stored;
    const plain = { curve, isStored, refusal: '', largest: 0, time: 0 };
    if (isStored) return { ...plain, converted: clip };
    const refusal = refusalOf(subject, curve);
    const source = character.skeleton.sourceIndex[joint]!;
    const done = refusal ? null : convertRotation(clip, character, source, curve, actor.q);
    if (!done) return { ...plain, refusal: refusal || 'It can’t be stored so.', converted: null };
    return { ...plain, converted: done.clip, largest: done.difference, time: done.time };
  });
}

function refusalOf({ name, charts: { angles } }: Subject, curve: RotationForm): string {
  if (curve === 'euler') {
    return angles ? '' : `${name} is a ball: it has no angles in which splines could be stored.`;
  }
  if (!angles || angles.length === 3) return '';
  return `${name} has ${angles.length === 1 ? 'one hinge' : `${angles.length} hinges`}; quaternions need three, or a ball.`;
}
