import type { Diagnostic, Place } from '../../core/diagnostics.ts';
import { channelFor, evaluateChannel } from '../../core/motion/channel.ts';
import {
  type ClipParts,
  isRotationChannel,
  type ScalarChannelParts,
} from '../../core/motion/clip-parts.ts';
import { type AnimatedThing, pinValues } from '../../core/motion/targets.ts';

/** A pin that a clip moves and that a character lacks: at a joint's origin. */
export interface MissingPin {
  readonly joint: number;
  /** In the character's space, model units, at the start of the clip. */
  readonly place: readonly [number, number, number];
  readonly weight: number;
}

/**
 * The pins that a clip moves, without those that the character has. A pin needs x, y and z; channels
 * of one without them move nothing, which is reported.
 *
 * @param pinned the joints that have pins
 * @param places where the file first moves the pin of a joint, by the joint's file index
 */
export function pinsToMake(
  { file, start, channels }: ClipParts,
  { skeleton }: AnimatedThing,
  pinned: readonly number[],
  places?: ReadonlyMap<number, Place>,
): { readonly pins: readonly MissingPin[]; readonly diagnostics: readonly Diagnostic[] } {
  const curves = new Map<number, Partial<Record<string, ScalarChannelParts>>>();
  for (const channel of channels) {
    if (isRotationChannel(channel) || channel.target?.of !== 'pin') continue;
    const joint = skeleton.jointOfSource[channel.target.joint];
    if (joint === undefined || pinned.includes(joint)) continue;
    curves.set(joint, { ...curves.get(joint), [channel.target.value]: channel });
  }
  const pins: MissingPin[] = [];
  const diagnostics: Diagnostic[] = [];
  for (const [joint, of] of curves) {
    const at = (value: string, otherwise: number): number => {
      const curve = of[value];
      return curve ? evaluateChannel(channelFor(curve), start) : otherwise;
    };
    if (of['x'] && of['y'] && of['z']) {
      const weight = Math.min(Math.max(at('weight', 1), 0), 1);
      pins.push({ joint, place: [at('x', 0), at('y', 0), at('z', 0)], weight });
    } else {
      const place = places?.get(skeleton.sourceIndex[joint]!) ?? {};
      diagnostics.push(incomplete(file, place, skeleton.names[joint]!, Object.keys(of)));
    }
  }
  return { pins, diagnostics };
}

function incomplete(
  file: string,
  place: Place,
  joint: string,
  found: readonly string[],
): Diagnostic {
  return {
    severity: 'warning',
    code: 'motion/missing',
    file,
    ...place,
    expected: `a pin at "${joint}", or ${pinValues.slice(0, 3).join(', ')} to make one`,
    found: found.join(', '),
    effect: 'they move nothing until the joint is pinned',
  };
}
