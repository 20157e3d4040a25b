import type { ClipParts, Extrapolation } from '../../core/motion/clip-parts.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { firstRoot } from '../../core/subtree.ts';

/** What of a skeleton a clip moves. */
export interface MovedJoints {
  /** The joints that turn. */
  readonly joints: readonly number[];
  /** Whether the first root slides, and how many slides of other joints there are. */
  readonly root: boolean;
  readonly otherSlides: number;
  /** The times of all these keys, in seconds. */
  readonly times: ReadonlySet<number>;
}

export function movedJoints({ channels }: ClipParts, skeleton: Skeleton): MovedJoints {
  const joints = new Set<number>();
  const times = new Set<number>();
  let [root, otherSlides] = [false, 0];
  for (const { target, keys } of channels) {
    if (target?.of !== 'value' && target?.of !== 'rotation') continue;
    const joint = skeleton.jointOfSource[target.joint];
    if (joint === undefined) continue;
    for (const { time } of keys) times.add(time);
    if (target.of === 'rotation' || target.kind === DofKind.hinge) joints.add(joint);
    else if (joint === firstRoot(skeleton)) root = true;
    else otherSlides++;
  }
  return { joints: [...joints], root, otherSlides, times };
}

/** When joints are sampled, and how their curves go on outside. */
export interface Window {
  readonly start: number;
  readonly end: number;
  readonly before: Extrapolation;
  readonly after: Extrapolation;
  /** Whether curves went on in other ways. */
  readonly isCut: boolean;
}

/** Rules that mean the same for any values of a joint. */
const common: readonly Extrapolation[] = ['constant', 'cycle', 'bounce'];

/**
 * If all joints have their first and last keys at the same times, and the same rules outside, these
 * stay. Otherwise the range with all keys is sampled, and the ends hold.
 */
export function windowOf({ channels, start, end }: ClipParts): Window {
  const moving = channels.filter(
    ({ target, keys }) => (target?.of === 'value' || target?.of === 'rotation') && keys.length > 1,
  );
  const extents = moving.map(({ keys, before, after }) => {
    return { start: keys[0]!.time, end: keys.at(-1)!.time, before, after };
  });
  const [first] = extents;
  const isSame = extents.every(
    (each) =>
      each.start === first!.start &&
      each.end === first!.end &&
      each.before === first!.before &&
      each.after === first!.after &&
      common.includes(each.before) &&
      common.includes(each.after),
  );
  if (first && isSame) return { ...first, isCut: false };
  return {
    start: Math.min(start, ...extents.map((each) => each.start)),
    end: Math.max(end, ...extents.map((each) => each.end)),
    before: 'constant',
    after: 'constant',
    isCut: extents.some(({ before, after }) => before !== 'constant' || after !== 'constant'),
  };
}
