import { sameValue } from '../../core/same-value.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import type { JsonValue } from '../../formats/json/decoder.ts';
import { findJoint } from '../../formats/pose-json.ts';
import {
  type NatureSettings,
  type OwnNature,
  plainNatures,
} from '../../posing/natural/nature-settings.ts';
import { checked, flag, numbers, numberWithin } from './codec.ts';
import { type Codecs, readFields, writeFields } from './fields.ts';
import { keyAt } from '../../formats/json/keys.ts';

/** In radians. */
const range = checked(
  numbers<readonly [number, number]>(2, 2 * Math.PI),
  ([low, high]) => low <= high,
  'a range, the lower end first',
);

/** The most that a joint can resist beside an elbow. */
export const stiffest = 1000;

const natureFields: Codecs<Omit<OwnNature, 'joint'>> = {
  stiffness: numberWithin(1 / stiffest, stiffest),
  bend: range,
  side: range,
  twist: range,
};

/** Returns the settings, or nothing if they are the plain ones. */
export function writeNatures(
  settings: NatureSettings,
  skeleton: Skeleton,
): Record<string, unknown> | undefined {
  if (sameValue(settings, plainNatures)) return undefined;
  // Built from entries, because a joint may have any name, even "__proto__".
  const joints = settings.own.map(
    ({ joint, ...nature }) =>
      [
        keyAt(skeleton.names, joint, skeleton.sourceIndex[joint]),
        writeFields(natureFields, nature),
      ] as const,
  );
  return {
    ...(!settings.isOn && { on: false }),
    ...(joints.length > 0 && { joints: Object.fromEntries(joints) }),
  };
}

/** Reads settings; a joint whose nature is wrong or not whole keeps the one that is found. */
export function readNatures(json: JsonValue, skeleton: Skeleton): NatureSettings {
  const members = json.record('an object');
  const [on, joints] = [members?.get('on'), members?.get('joints')];
  const own = new Map<number, OwnNature>();
  for (const [key, member] of joints?.record('natures by joint') ?? []) {
    const joint = findJoint(skeleton, key);
    if (typeof joint === 'string') {
      member.failName('unknown-joint', joint, key);
      continue;
    }
    const { stiffness, bend, side, twist } = readFields(natureFields, member) ?? {};
    if (stiffness !== undefined && bend && side && twist) {
      own.set(joint, { joint, stiffness, bend, side, twist });
    } else member.fail('json', '"stiffness", "bend", "side" and "twist"');
  }
  const settings = {
    isOn: on ? (flag.read(on) ?? true) : true,
    own: [...own.values()].sort((a, b) => a.joint - b.joint),
  };
  return sameValue(settings, plainNatures) ? plainNatures : settings;
}
