import type { Character } from '../../core/character.ts';
import { printable } from '../../core/diagnostics.ts';
import type { ClipParts } from '../../core/motion/clip-parts.ts';
import type { Actor } from '../../document/scene.ts';
import { type ChartCurve, chartCurve } from '../../posing/charts/chart-curve.ts';
import { type JointCharts, jointCharts } from '../../posing/charts/joint-charts.ts';
import { type JointMotion, jointMotion } from '../../posing/charts/joint-motion.ts';

/** What the rotation lab is about: what a clip does to the rotation of a joint. */
export interface Subject {
  readonly actor: Actor;
  readonly joint: number;
  /** The joint's name, for text. */
  readonly name: string;
  /** What the twist is about, for text. */
  readonly boneName: string;
  /** The clip and its index. */
  readonly clip: ClipParts;
  readonly index: number;
  readonly motion: JointMotion;
  readonly charts: JointCharts;
  /** The motion in each chart. */
  readonly curves: readonly ChartCurve[];
}

/** Returns what the lab is about, or why there is nothing to show, for the user. */
export function subjectOf(
  actor: Actor | undefined,
  index: number,
  joint: number | null,
): Subject | string {
  if (!actor) return 'There is no character.';
  const clip = actor.clips[index];
  if (!clip)
    return `${printable(actor.name, 80)} has no clip. Key a pose, and a joint's motion is drawn here.`;
  if (joint === null) return 'Select a joint that the clip turns; its motion is drawn here.';
  const { character } = actor;
  const name = printable(character.skeleton.names[joint]!, 80);
  const charts = jointCharts(character, joint);
  if (!charts) return `${name} can't turn. Select a joint that can.`;
  const motion = jointMotion(character, joint, clip, actor.q);
  if (!motion) return `The clip does not turn ${name}. Select a joint that it turns.`;
  const { angles } = charts;
  const isInAngles = angles !== null && motion.stored === 'euler';
  const stored = isInAngles && motion.values.map((q) => angles.map((at) => q[at]!));
  const curves = charts.charts.map((chart) =>
    chartCurve(chart, motion, (chart.id === 'euler' && stored) || undefined),
  );
  const boneName = boneText(character, charts.boneEnd);
  return { actor, joint, name, boneName, clip, index, motion, charts, curves };
}

function boneText({ skeleton }: Character, end: number): string {
  return end < 0 ? 'the bone' : `the bone to ${printable(skeleton.names[end]!, 80)}`;
}
