import { slotOf } from '../../core/motion/targets.ts';
import { jointOfValue } from '../../core/pose.ts';
import type { Actor } from '../../document/scene.ts';
import type { RowPicture } from './draw-rows.ts';
import type { TimelineRow } from './rows.ts';

/** Finds the rows whose values were edited over the clip, and are not in it. */
export function unkeyedRows({ character, unkeyed }: Actor): RowPicture['unkeyed'] {
  if (!unkeyed) return null;
  const { time } = unkeyed;
  const [values, morphs, pins] = [unkeyed.values, unkeyed.morphs, unkeyed.pins].map(
    (list) => new Set(list),
  ) as [Set<number>, Set<number>, Set<number>];
  const { skeleton } = character;
  const joints = new Set(unkeyed.values.map((index) => jointOfValue(skeleton, index)));
  const hasChannel = ({ channels, joint }: TimelineRow): boolean => {
    const target = channels[0]?.target;
    if (!target) return false;
    if (target.of === 'rotation') return joint !== null && joints.has(joint);
    const slot = slotOf(target, character);
    if (target.of === 'morph') return morphs.has(target.morph);
    if (target.of === 'pin') return pins.has(skeleton.jointOfSource[target.joint]!);
    return slot !== null && values.has(slot.index);
  };
  const has = (row: TimelineRow): boolean => {
    if (row.kind === 'all') return values.size + morphs.size + pins.size > 0;
    if (row.kind === 'joint') return joints.has(row.joint!);
    if (row.kind === 'group') return (row.id === 'morph' ? morphs : pins).size > 0;
    return hasChannel(row);
  };
  return { time, has };
}
