import type { Quaternion, Vector3 } from '../ik/problem.ts';

/** A joint that is held; the other joints move so that it stays. At most one per joint. */
export interface Pin {
  readonly joint: number;
  /** The point that is held, in the joint's frame, model units; zero is the joint's origin. */
  readonly point: Vector3;
  /**
   * Where that point is held, in the character's space, model units. If the pin follows another
   * character, this is where it was last.
   */
  readonly place: Vector3;
  /** `characterFromJoint` as a unit quaternion xyzw; null if the joint may turn about the point. */
  readonly rotation: Quaternion | null;
  /** From 0 to 1: how much it counts against the other pins; 0 lets the joint go. */
  readonly weight: number;
  readonly follows: Followed | null;
}

/** A joint of another character, which a pin follows. */
export interface Followed {
  /** The id of the other actor. */
  readonly actor: number;
  readonly joint: number;
  /** The point that is followed, in the followed joint's frame, in its character's model units. */
  readonly point: Vector3;
  /** `followedJointFromJoint` as a unit quaternion xyzw, used if the pin holds the orientation. */
  readonly rotation: Quaternion;
}

/** Every character without pins has this list, so that lists without pins are identical. */
export const noPins: readonly Pin[] = [];
