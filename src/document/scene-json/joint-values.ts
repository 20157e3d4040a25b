import { defaultLimits } from '../../core/limits.ts';
import { jointRange } from '../../core/pose.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import type { JsonValue } from '../../formats/json/decoder.ts';
import { findJoint } from '../../formats/pose-json.ts';
import { keyAt } from '../../formats/json/keys.ts';

/**
 * Returns the values of q by joint, for the joints that differ from the file's pose. Unlike
 * POSE.json it has every value of these joints, in stored order, so that the exact bits return.
 */
export function writeJointValues(skeleton: Skeleton, q: Float64Array): Record<string, unknown> {
  const written: [string, number[]][] = [];
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const [from, to] = jointRange(skeleton, joint);
    const values = [...q.subarray(from, to)];
    if (values.every((value, i) => Object.is(value, skeleton.qRest[from + i]))) continue;
    written.push([keyAt(skeleton.names, joint, skeleton.sourceIndex[joint]), values]);
  }
  // Built from entries, because a joint may have any name, even "__proto__".
  return Object.fromEntries(written);
}

/** Sets the values that a record names; a joint whose values are wrong stays as it is in q. */
export function readJointValues(json: JsonValue, skeleton: Skeleton, q: Float64Array): void {
  for (const [key, member] of json.record('values by joint') ?? []) {
    const joint = findJoint(skeleton, key);
    if (typeof joint === 'string') {
      member.failName('unknown-joint', joint, key);
      continue;
    }
    const [from, to] = jointRange(skeleton, joint);
    const values = member.numbers([to - from], `${to - from} numbers for "${key}"`);
    if (!values) continue;
    const wrong = values.findIndex((value, i) => !isWithin(skeleton, from + i, value));
    if (wrong < 0) q.set(values, from);
    else member.member(wrong).fail('range', `a value within the limits of "${key}"`);
  }
}

function isWithin({ qMin, qMax }: Skeleton, index: number, value: number): boolean {
  const isSmall = Math.abs(value) <= defaultLimits.coordinate;
  return isSmall && value >= qMin[index]! && value <= qMax[index]!;
}
