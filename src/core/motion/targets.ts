import { axisDofs } from '../pose.ts';
import type { Skeleton } from '../skeleton.ts';
import type { ChannelTarget, PinValue, ScalarTarget } from './clip-parts.ts';

/** What a clip can move. */
export interface AnimatedThing {
  readonly skeleton: Skeleton;
  readonly morphs: readonly { readonly name: string }[];
}

/** The lists of numbers that curves are written into. */
export type SlotList = 'q' | 'morphWeights' | 'pins';

/** The place of a target's value. */
export interface Slot {
  readonly list: SlotList;
  /** In q; in the weights of morphs; or for pins, the joint × 4 and x, y, z or the weight. */
  readonly index: number;
  /** What the value is clamped to. */
  readonly minimum: number;
  readonly maximum: number;
}

/** The values of a pin, in their order. */
export const pinValues: readonly PinValue[] = ['x', 'y', 'z', 'weight'];

type TargetOf<Kind extends ScalarTarget['of']> = Extract<ScalarTarget, { of: Kind }>;

/** Finds where a target's value stands, or returns null if the character does not have it. */
type Find<Kind extends ScalarTarget['of']> = (
  target: TargetOf<Kind>,
  thing: AnimatedThing,
) => Slot | null;

/** Every kind of target whose value is one number. To add one, add its type and its row. */
const kinds: { readonly [Kind in ScalarTarget['of']]: Find<Kind> } = {
  value: ({ joint: source, kind, axis }, { skeleton }) => {
    const joint = skeleton.jointOfSource[source];
    if (joint === undefined) return null;
    const dof = axisDofs(skeleton, joint).find((each) => each.kind === kind && each.axis === axis);
    if (!dof) return null;
    const { index } = dof;
    const [minimum, maximum] = [skeleton.qMin[index]!, skeleton.qMax[index]!];
    return { list: 'q', index, minimum, maximum };
  },
  morph: ({ morph }, { morphs }) =>
    morphs[morph]
      ? { list: 'morphWeights', index: morph, minimum: -Infinity, maximum: Infinity }
      : null,
  pin: ({ joint: source, value }, { skeleton }) => {
    const joint = skeleton.jointOfSource[source];
    if (joint === undefined) return null;
    const limits =
      value === 'weight' ? { minimum: 0, maximum: 1 } : { minimum: -Infinity, maximum: Infinity };
    return { list: 'pins', index: joint * pinValues.length + pinValues.indexOf(value), ...limits };
  },
};

/** Returns where a target's value stands, or null if the character does not have it. */
export function slotOf(target: ScalarTarget, thing: AnimatedThing): Slot | null {
  return (kinds[target.of] as Find<ScalarTarget['of']>)(target, thing);
}

/** Identifies a channel in its clip: a clip has one channel for each target. */
export type ChannelKey = string;

export function channelKey(target: ChannelTarget): ChannelKey {
  switch (target.of) {
    case 'value':
      return `value ${target.joint} ${target.kind} ${target.axis}`;
    case 'rotation':
      return `rotation ${target.joint}`;
    case 'morph':
      return `morph ${target.morph}`;
    case 'pin':
      return `pin ${target.joint} ${target.value}`;
  }
}
