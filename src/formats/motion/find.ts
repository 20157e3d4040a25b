import type { AnimatedThing } from '../../core/motion/targets.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import type { JsonValue } from '../json/decoder.ts';
import { keyAt } from '../json/keys.ts';
import { findJoint } from '../pose-json.ts';

const indexed = /^#\d{1,6}$/;

/** The joint of a name or of `#index`, or reports why there is none. */
export function jointOf(skeleton: Skeleton, name: string, json: JsonValue): number | undefined {
  const joint = findJoint(skeleton, name);
  if (typeof joint === 'number') return joint;
  json.fail('unknown-joint', joint, name);
  return undefined;
}

/** The file index of the joint of a name, or of `#index`, which may be absent. */
export function sourceOf(skeleton: Skeleton, name: string, json: JsonValue): number | undefined {
  if (indexed.test(name)) return Number(name.slice(1));
  const joint = jointOf(skeleton, name, json);
  return joint === undefined ? undefined : skeleton.sourceIndex[joint];
}

/** The name of a joint by its file index, or `#` and that index if it is absent or not clear. */
export function nameOfSource({ names, jointOfSource }: Skeleton, source: number): string {
  const joint = jointOfSource[source];
  return joint === undefined ? `#${source}` : keyAt(names, joint, source);
}

/** The morph of a name, or of `#index`, which may be absent. */
export function locateMorph(
  morphs: AnimatedThing['morphs'],
  name: string,
  json: JsonValue,
): number | undefined {
  if (indexed.test(name)) return Number(name.slice(1));
  return morphOf(morphs, name, json);
}

/** The morph of a name or of `#index`, or reports why there is none. */
export function morphOf(
  morphs: AnimatedThing['morphs'],
  name: string,
  json: JsonValue,
): number | undefined {
  const morph = findMorph(morphs, name);
  if (typeof morph === 'number') return morph;
  json.fail('unknown-morph', morph, name);
  return undefined;
}

/** The morph of a name or of `#index`, or the text that says what was expected. */
function findMorph(morphs: AnimatedThing['morphs'], name: string): number | string {
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
