import {
  type ChannelParts,
  type ClipParts,
  isRotationChannel,
  type RotationChannelParts,
  type ScalarChannelParts,
  type ScalarTarget,
} from '../../core/motion/clip-parts.ts';
import { type AnimatedThing, type ChannelKey, channelKey } from '../../core/motion/targets.ts';
import { DofKind } from '../../core/skeleton.ts';
import { axisNames } from '../joint-values.ts';
import type { ValueUnit } from './value-axis.ts';

/** A channel of a clip as the curve editor lists it. */
export interface ShownCurve {
  readonly key: ChannelKey;
  /** "Left elbow X", "Left elbow Move X", "smile", "Pin of Left foot X". */
  readonly name: string;
  /** The name of its color: that of its axis, or one of the others. */
  readonly color: string;
  /** Whether its line is dotted, which tells slides and pins from angles in the same colors. */
  readonly isDotted: boolean;
  readonly unit: ValueUnit;
  readonly channel: EditedChannel;
}

/** A channel whose target is known. */
export type EditedChannel =
  | (ScalarChannelParts & { readonly target: ScalarTarget })
  | RotationChannelParts;

/** As many colors as curves have that belong to no axis. */
export const otherColorCount = 6;

/** Which channels are listed. */
interface Wanted {
  /** The joints whose channels and pins are listed, or null for all of them. */
  readonly joints: readonly number[] | null;
  readonly morphs: boolean;
}

/**
 * Lists a clip's channels, each joint's slides before its angles and by axis, then pins and morphs.
 */
export function shownCurves(
  clip: ClipParts,
  thing: AnimatedThing,
  wanted: Wanted,
): readonly ShownCurve[] {
  const known = clip.channels.filter(isKnown);
  const curves = known.filter(({ target }) => isWanted(target, thing, wanted));
  let others = 0;
  return curves
    .map((channel) => ({ channel, rank: rankOf(channel.target, thing) }))
    .sort((a, b) => compare(a.rank, b.rank))
    .map(({ channel }) => {
      const color = axisColor(channel.target) ?? `other-${others++ % otherColorCount}`;
      return { ...describe(channel, thing), color };
    });
}

function isKnown(channel: ChannelParts): channel is EditedChannel {
  return channel.target !== null;
}

function isWanted(
  target: EditedChannel['target'],
  { skeleton, morphs }: AnimatedThing,
  wanted: Wanted,
): boolean {
  if (target.of === 'morph') return wanted.morphs && morphs[target.morph] !== undefined;
  const { joints } = wanted;
  const joint = skeleton.jointOfSource[target.joint];
  return joint !== undefined && (joints === null || joints.includes(joint));
}

const axisLetters = ['x', 'y', 'z'] as const;

function axisColor(target: EditedChannel['target']): string | null {
  if (target.of === 'value') return axisLetters[target.axis];
  return target.of === 'pin' && target.value !== 'weight' ? target.value : null;
}

/** Joints by their order with their slides first, then pins, then morphs. */
function rankOf(target: EditedChannel['target'], { skeleton }: AnimatedThing): number[] {
  if (target.of === 'morph') return [2, target.morph];
  const joint = skeleton.jointOfSource[target.joint]!;
  if (target.of === 'pin') return [1, joint, ['x', 'y', 'z', 'weight'].indexOf(target.value)];
  if (target.of === 'rotation') return [0, joint, 2, 0];
  return [0, joint, target.kind === DofKind.slide ? 0 : 1, target.axis];
}

function compare(a: readonly number[], b: readonly number[]): number {
  const at = a.findIndex((part, i) => part !== b[i]);
  return at < 0 ? 0 : a[at]! - (b[at] ?? 0);
}

function describe(channel: EditedChannel, thing: AnimatedThing): Omit<ShownCurve, 'color'> {
  const { target } = channel;
  const key = channelKey(target);
  const [name, unit, isDotted] = namesOf(target, thing);
  return { key, name, unit, isDotted, channel };
}

function namesOf(
  target: EditedChannel['target'],
  { skeleton, morphs }: AnimatedThing,
): readonly [name: string, unit: ValueUnit, isDotted: boolean] {
  if (target.of === 'morph') return [morphs[target.morph]!.name, 'number', false];
  const joint = skeleton.names[skeleton.jointOfSource[target.joint]!] ?? '';
  if (target.of === 'rotation') return [`${joint} rotation`, 'angle', false];
  if (target.of === 'pin') {
    if (target.value === 'weight') return [`Pin of ${joint} weight`, 'number', false];
    return [`Pin of ${joint} ${target.value.toUpperCase()}`, 'length', true];
  }
  const isSlide = target.kind === DofKind.slide;
  const name = `${joint} ${isSlide ? 'Move ' : ''}${axisNames[target.axis]}`;
  return [name, isSlide ? 'length' : 'angle', isSlide];
}

/** Whether the curve is one of numbers, which can be moved in value and has slopes. */
export function scalarOf({ channel }: ShownCurve): ScalarChannelParts | null {
  return isRotationChannel(channel) ? null : channel;
}
