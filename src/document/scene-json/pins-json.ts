import { defaultLimits } from '../../core/limits.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import type { JsonValue } from '../../formats/json/decoder.ts';
import { findJoint } from '../../formats/pose-json.ts';
import type { Quaternion, Vector3 } from '../../posing/ik/problem.ts';
import { type Followed, noPins, type Pin } from '../../posing/pins/pin.ts';
import type { Actor, ActorId } from '../scene.ts';
import { checked, index, numbers, numberWithin, orNull } from './codec.ts';
import { type Codecs, readFields, writeFields } from './fields.ts';
import { keyAt } from '../../formats/json/keys.ts';

/** Returns the actor at an index of the scene's list, if it is there. */
export type FindActor = (
  index: number,
) => { readonly id: ActorId; readonly skeleton: Skeleton } | undefined;

const { coordinate } = defaultLimits;

const vector = numbers<Vector3>(3, coordinate);

const rotation = checked(
  numbers<Quaternion>(4, 1.001),
  (quaternion) => Math.abs(Math.hypot(...quaternion) - 1) < 1e-3,
  'a quaternion of length 1',
);

/** Joints are written by name, and actors by their index. */
const pinFields: Codecs<Omit<Pin, 'joint' | 'follows'>> = {
  point: vector,
  place: vector,
  rotation: orNull(rotation),
  weight: numberWithin(0, 1),
};

const plainPin = { point: [0, 0, 0], rotation: null, weight: 1 } as const;

const followedFields: Codecs<Pick<Followed, 'point' | 'rotation'>> = { point: vector, rotation };

const plainFollowed = { point: [0, 0, 0], rotation: [0, 0, 0, 1] } as const;

/** @param actors all of the scene; a pin that follows none of them is written as a plain one */
export function writePins(
  { pins, character: { skeleton } }: Actor,
  actors: readonly Actor[],
): readonly unknown[] {
  return pins.map((pin) => {
    const actor = actors.findIndex(({ id }) => id === pin.follows?.actor);
    const other = actors[actor]?.character.skeleton;
    return {
      joint: keyOf(skeleton, pin.joint),
      ...writeFields(pinFields, pin, plainPin),
      ...(pin.follows &&
        other && {
          follows: {
            actor,
            joint: keyOf(other, pin.follows.joint),
            ...writeFields(followedFields, pin.follows, plainFollowed),
          },
        }),
    };
  });
}

/** Reads pins; one without a joint or a place is reported and left out. */
export function readPins(json: JsonValue, skeleton: Skeleton, found: FindActor): readonly Pin[] {
  const pins = new Map<number, Pin>();
  for (const item of json.list(skeleton.jointCount, 'a list of at most one pin a joint') ?? []) {
    const joint = readJoint(item.member('joint'), skeleton);
    const read = readFields(pinFields, item, ['joint', 'follows']);
    if (joint === undefined || !read) continue;
    if (!read.place) {
      item.member('place').fail('json', '"place" to be three numbers');
      continue;
    }
    const follows = item.record('a pin')?.get('follows');
    const followed = follows ? readFollowed(follows, found) : undefined;
    const pin = { ...plainPin, ...read, place: read.place };
    pins.set(joint, { ...pin, joint, follows: followed ?? null });
  }
  return pins.size > 0 ? [...pins.values()] : noPins;
}

/** A pin whose followed character is not there stays where it was last. */
function readFollowed(json: JsonValue, found: FindActor): Followed | undefined {
  const at = index.read(json.member('actor'));
  const other = at === undefined ? undefined : found(at);
  const joint = other && readJoint(json.member('joint'), other.skeleton);
  const read = readFields(followedFields, json, ['actor', 'joint']);
  if (!other || joint === undefined || !read) return undefined;
  return { ...plainFollowed, ...read, actor: other.id, joint };
}

function readJoint(json: JsonValue, skeleton: Skeleton): number | undefined {
  const joint = typeof json.value === 'string' ? findJoint(skeleton, json.value) : 'a name';
  if (typeof joint === 'number') return joint;
  json.fail('unknown-joint', joint);
  return undefined;
}

function keyOf({ names, sourceIndex }: Skeleton, joint: number): string {
  return keyAt(names, joint, sourceIndex[joint]);
}
