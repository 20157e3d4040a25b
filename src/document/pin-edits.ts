import { quat } from 'gl-matrix';
import { assert } from '../core/assert.ts';
import type { Quaternion, Vector3 } from '../posing/ik/problem.ts';
import { type Followed, noPins, type Pin } from '../posing/pins/pin.ts';
import { jointRotation, pinnedPoint } from '../posing/pins/pin-target.ts';
import { type Edit, editActor } from './edit.ts';
import { follows } from './followers.ts';
import type { Actor, ActorId, Scene } from './scene.ts';

/** An actor and its joints as they are shown, from which a pin takes its place. */
export interface ShownJoints {
  readonly state: Actor;
  /** (jointCount × 16) */
  readonly characterFromJoint: Float64Array;
}

export function pinOf({ pins }: Pick<Actor, 'pins'>, joint: number): Pin | undefined {
  return pins.find((pin) => pin.joint === joint);
}

/** Holds joints where they are shown. */
export function pinJoints(
  { state, characterFromJoint }: ShownJoints,
  joints: readonly number[],
): Edit {
  const added = joints
    .filter((joint) => !pinOf(state, joint))
    .map((joint): Pin => {
      const point: Vector3 = [0, 0, 0];
      const place = pinnedPoint({ joint, point }, characterFromJoint);
      return { joint, point, place, rotation: null, weight: 1, follows: null };
    });
  const label = `Pin ${namesOf(state, joints)}`;
  return editActor(state.id, label, (actor) => ({ ...actor, pins: [...actor.pins, ...added] }));
}

/** Lets joints go; their pose stays as it is shown. */
export function unpinJoints(state: Actor, joints: readonly number[]): Edit {
  return editActor(state.id, `Unpin ${namesOf(state, joints)}`, (actor) => {
    const pins = actor.pins.filter(({ joint }) => !joints.includes(joint));
    return { ...actor, pins: pins.length > 0 ? pins : noPins };
  });
}

export function setPinWeight(state: Actor, joint: number, weight: number): Edit {
  assert(weight >= 0 && weight <= 1, 'a weight from 0 to 1');
  return editPin(state, joint, `Weigh the pin of ${nameOf(state, joint)}`, (pin) => ({
    ...pin,
    weight,
  }));
}

/** Holds a pinned joint's orientation as it is shown too, or only its place. */
export function holdRotation(shown: ShownJoints, joint: number, holds: boolean): Edit {
  const { state, characterFromJoint } = shown;
  const label = `${holds ? 'Hold' : 'Free'} the orientation of ${nameOf(state, joint)}`;
  return editPin(state, joint, label, (pin) => ({
    ...pin,
    rotation: holds ? jointRotation(joint, characterFromJoint) : null,
  }));
}

/** Moves a pin to another place of the character's space; it then follows nobody. */
export function movePin(state: Actor, joint: number, place: Vector3, rotation?: Quaternion): Edit {
  return editPin(state, joint, `Move the pin of ${nameOf(state, joint)}`, (pin) => ({
    ...pin,
    place,
    rotation: pin.rotation && (rotation ?? pin.rotation),
    follows: null,
  }));
}

/**
 * Lets a pin follow a joint of another actor. The pin is made if there is none.
 *
 * @param point the point that is held, in the pinned joint's frame
 */
export function followJoint(
  shown: ShownJoints,
  joint: number,
  point: Vector3,
  followed: Followed,
  label: string,
): Edit {
  const { state, characterFromJoint } = shown;
  const place = pinnedPoint({ joint, point }, characterFromJoint);
  const held: Pin = { joint, point, place, rotation: null, weight: 1, follows: followed };
  return editActor(state.id, label, (actor) => {
    const old = pinOf(actor, joint);
    const pin = old ? { ...old, point, place, follows: followed } : held;
    return { ...actor, pins: [...actor.pins.filter((each) => each !== old), pin] };
  });
}

/** The rotation between two joints of different characters as they are shown, for `Followed`. */
export function rotationBetween(
  own: ShownJoints,
  joint: number,
  other: ShownJoints,
  otherJoint: number,
): Quaternion {
  const sceneFromOther = sceneRotation(other, otherJoint);
  quat.conjugate(sceneFromOther, sceneFromOther);
  const between = quat.multiply(sceneFromOther, sceneFromOther, sceneRotation(own, joint));
  return [between[0], between[1], between[2], between[3]];
}

function sceneRotation({ state, characterFromJoint }: ShownJoints, joint: number): quat {
  const rotation = [...jointRotation(joint, characterFromJoint)] as const;
  return quat.multiply(new Float64Array(4), state.transform.rotation, rotation);
}

/** Lets a pin hold its place instead of following another character. */
export function holdPlace(shown: ShownJoints, joint: number): Edit {
  const { state, characterFromJoint } = shown;
  return editPin(state, joint, `Hold the place of ${nameOf(state, joint)}`, (pin) => ({
    ...pin,
    place: pinnedPoint(pin, characterFromJoint),
    rotation: pin.rotation && jointRotation(joint, characterFromJoint),
    follows: null,
  }));
}

/** Why an actor's pin can't follow another actor, or null if it can. */
export function whyNoFollowing(scene: Scene, follower: ActorId, followed: ActorId): string | null {
  const nameOfActor = (id: ActorId): string =>
    scene.actors.find((actor) => actor.id === id)?.name ?? '';
  if (follower === followed) return 'A pin follows a joint of another character';
  if (!follows(scene, followed, follower)) return null;
  const [own, other] = [nameOfActor(follower), nameOfActor(followed)];
  return `${own} can't follow ${other}, because ${other} follows ${own} already`;
}

/** @param state with its pins as they are shown, which a clip may move */
function editPin(state: Actor, joint: number, label: string, edit: (pin: Pin) => Pin): Edit {
  const seen = pinOf(state, joint);
  const from = (pin: Pin): Pin => (seen ? { ...pin, place: seen.place, weight: seen.weight } : pin);
  return editActor(state.id, label, (actor) => ({
    ...actor,
    pins: actor.pins.map((pin) => (pin.joint === joint ? edit(from(pin)) : pin)),
  }));
}

function nameOf({ character }: Actor, joint: number): string {
  return character.skeleton.names[joint]!;
}

function namesOf(state: Actor, joints: readonly number[]): string {
  const more = joints.length > 1 ? ` and ${joints.length - 1} more` : '';
  return `${nameOf(state, joints[0]!)}${more}`;
}
