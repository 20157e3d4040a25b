import type { AnimatedThing } from '../../core/motion/targets.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import type { JsonValue } from '../json/decoder.ts';
import { findJoint } from '../pose-json.ts';

/** The joint that a target names, or reports why there is none. */
export function jointOf(skeleton: Skeleton, name: string, target: JsonValue): number | undefined {
  const joint = findJoint(skeleton, name);
  if (typeof joint === 'number') return joint;
  target.member('joint').fail('unknown-joint', joint, name);
  return undefined;
}

/** The morph of a name or of `#index`, or the text that says what was expected. */
export function findMorph(morphs: AnimatedThing['morphs'], name: string): number | string {
  if (/^#\d+$/.test(name)) {
    const index = Number(name.slice(1));
    if (morphs[index]) return index;
    return morphs.length === 0 ? 'no morph' : `a morph from #0 to #${morphs.length - 1}`;
  }
  const index = morphs.findIndex((each) => each.name === name);
  if (index < 0) return 'the name of a morph, or # and its index';
  const isClear = morphs.findLastIndex((each) => each.name === name) === index;
  return isClear ? index : 'a name that only one morph has';
}
