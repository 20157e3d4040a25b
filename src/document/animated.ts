import type { ChannelParts, ClipParts, RotationTarget } from '../core/motion/clip-parts.ts';
import { type AnimatedThing, pinValues, slotOf } from '../core/motion/targets.ts';
import { jointRange } from '../core/pose.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';

type Channels = ReadonlyMap<number, readonly ChannelParts[]>;

/** The curves of a clip by what they move in a character. */
export interface Animated {
  /** By the index in q. */
  readonly values: Channels;
  /** By the index of the morph. */
  readonly morphs: Channels;
  /** By the pinned joint. */
  readonly pins: Channels;
}

/** Finds which of a character's values a clip moves; cached while both exist. */
export function animatedBy(clip: ClipParts, thing: AnimatedThing): Animated {
  let found = known.get(thing);
  if (!found) known.set(thing, (found = new WeakMap<ClipParts, Animated>()));
  let animated = found.get(clip);
  if (!animated) found.set(clip, (animated = findAnimated(clip, thing)));
  return animated;
}

const known = new WeakMap<AnimatedThing, WeakMap<ClipParts, Animated>>();

function findAnimated(clip: ClipParts, thing: AnimatedThing): Animated {
  const lists = {
    q: new Map<number, ChannelParts[]>(),
    morphWeights: new Map<number, ChannelParts[]>(),
    pins: new Map<number, ChannelParts[]>(),
  };
  const add = (list: keyof typeof lists, at: number, channel: ChannelParts): void => {
    lists[list].set(at, [...(lists[list].get(at) ?? []), channel]);
  };
  for (const channel of clip.channels) {
    const { target } = channel;
    if (!target) continue;
    if (target.of === 'rotation') {
      for (const index of turnsOf(thing.skeleton, target)) add('q', index, channel);
      continue;
    }
    const slot = slotOf(target, thing);
    if (!slot) continue;
    const at = slot.list === 'pins' ? Math.floor(slot.index / pinValues.length) : slot.index;
    add(slot.list, at, channel);
  }
  return { values: lists.q, morphs: lists.morphWeights, pins: lists.pins };
}

/** The indices of q that a curve of a joint's rotation moves. */
function turnsOf(skeleton: Skeleton, { joint: source }: RotationTarget): readonly number[] {
  const joint = skeleton.jointOfSource[source];
  return joint === undefined ? [] : rotationOf(skeleton, joint);
}

/** The indices of q that turn a joint: those of its ball or of its hinges. */
export function rotationOf(skeleton: Skeleton, joint: number): readonly number[] {
  const { dofStart, dofKind, dofQ } = skeleton;
  const [, end] = jointRange(skeleton, joint);
  const found: number[] = [];
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    if (dofKind[dof] === DofKind.slide) continue;
    const next = dof + 1 < dofStart[joint + 1]! ? dofQ[dof + 1]! : end;
    for (let index = dofQ[dof]!; index < next; index++) found.push(index);
  }
  return found;
}
