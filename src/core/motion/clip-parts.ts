import type { DofKind } from '../skeleton.ts';

/** An animation: curves for some of a character's values. A value that is never changed in place. */
export interface ClipParts {
  readonly file: string;
  readonly name: string;
  /** The range that is played, in seconds, independent of the keys' times. */
  readonly start: number;
  readonly end: number;
  /** Frames a second, to which keys snap and by which steps go; curves are not sampled at them. */
  readonly fps: number;
  readonly channels: readonly ChannelParts[];
  /** Channels of a file whose targets are not known, as they were, for saving; absent if none. */
  readonly unread?: readonly unknown[];
}

/** The rate of files that do not say one. */
export const defaultFps = 30;

/** How a curve continues outside its keys. */
export type Extrapolation = 'constant' | 'linear' | 'cycle' | 'cycle_offset' | 'bounce';

export type Tcb = readonly [tension: number, continuity: number, bias: number];

/**
 * The slope at a key: a rule, or a number in value per second. A span is stepped if the tangent out
 * of its first key or the one into its second key is.
 */
export type Tangent =
  | 'flat'
  | 'linear'
  | 'smooth'
  | 'auto'
  | 'stepped'
  | number
  | { readonly tcb: Tcb };

/** A clip without rotations, as the courses' files have it. */
export interface ScalarClipParts extends ClipParts {
  readonly channels: readonly ScalarChannelParts[];
}

export type ChannelParts = ScalarChannelParts | RotationChannelParts;

/** A curve of one number. */
export interface ScalarChannelParts {
  /** The number that the curve moves, or null if the character does not have it. */
  readonly target: ScalarTarget | null;
  readonly before: Extrapolation;
  readonly after: Extrapolation;
  /** At increasing times. */
  readonly keys: readonly KeyParts[];
}

export interface KeyParts {
  /** In seconds. */
  readonly time: number;
  readonly value: number;
  readonly tangentIn: Tangent;
  readonly tangentOut: Tangent;
}

/** A curve of a joint's whole rotation, through quaternions. */
export interface RotationChannelParts {
  readonly target: RotationTarget;
  readonly before: Extrapolation;
  readonly after: Extrapolation;
  /** At increasing times. */
  readonly keys: readonly RotationKeyParts[];
}

export interface RotationKeyParts {
  /** In seconds. */
  readonly time: number;
  /** Unit quaternion xyzw: the product of the joint's own turns, without its rest rotation. */
  readonly value: Quaternion;
}

export type Quaternion = readonly [x: number, y: number, z: number, w: number];

/** What a channel moves. Each kind has a row in targets.ts. */
export type ChannelTarget = ScalarTarget | RotationTarget;

export type ScalarTarget = ValueTarget | MorphTarget | PinTarget;

/** One value of q: a slide (model units) or a hinge (radians) of a joint. */
export interface ValueTarget {
  readonly of: 'value';
  /** File index of the joint. */
  readonly joint: number;
  readonly kind: typeof DofKind.slide | typeof DofKind.hinge;
  readonly axis: 0 | 1 | 2;
}

/** The rotation of a joint with a ball or three hinges. */
export interface RotationTarget {
  readonly of: 'rotation';
  /** File index of the joint. */
  readonly joint: number;
  readonly curve: RotationCurve;
}

/** How a rotation goes from key to key: by the shortest arc, or smoothly through them. */
export type RotationCurve = 'slerp' | 'squad';

/** The weight of a morph. */
export interface MorphTarget {
  readonly of: 'morph';
  /** Its index in the character's morphs. */
  readonly morph: number;
}

/** A coordinate of a pin's place (character space, model units), or its weight. */
export interface PinTarget {
  readonly of: 'pin';
  /** File index of the pinned joint. */
  readonly joint: number;
  readonly value: PinValue;
}

export type PinValue = 'x' | 'y' | 'z' | 'weight';

export function isRotationChannel(channel: ChannelParts): channel is RotationChannelParts {
  return channel.target?.of === 'rotation';
}
